// The C headers behind the symbolic arithmetic, for .cpp files only: FLINT defines macros with short lower-case names.
// Two things need care in C++: fmpz_mpoly_q.h opens an extern "C" block around headers that include C++ ones, so those
// come first; and calcium.h, which it includes without using, is not valid C++, so its guard is set beforehand.
#pragma once

#include <gmp.h>
#include <mpfr.h>

#include <flint/fmpq.h>
#include <flint/fmpq_mpoly.h>
#include <flint/fmpz_mpoly.h>

#include <acb.h>

#define CALCIUM_H
#include <calcium/fmpz_mpoly_q.h>
#undef CALCIUM_H
