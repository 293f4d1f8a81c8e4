# FLINT 2.9 with Arb and Calcium, as Debian packages them: targets FLINT::flint, FLINT::arb, FLINT::calcium.
find_path(FLINT_INCLUDE_DIR flint/fmpz_mpoly.h)
find_path(FLINT_ARB_INCLUDE_DIR arb.h)
find_path(FLINT_CALCIUM_INCLUDE_DIR calcium/fmpz_mpoly_q.h)
find_library(FLINT_LIBRARY flint)
find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
find_library(FLINT_CALCIUM_LIBRARY calcium)
set(flint_variables FLINT_LIBRARY FLINT_INCLUDE_DIR FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR FLINT_CALCIUM_LIBRARY
                    FLINT_CALCIUM_INCLUDE_DIR)
mark_as_advanced(${flint_variables})
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS ${flint_variables})

function(flint_target name prefix)
  add_library(FLINT::${name} UNKNOWN IMPORTED)
  set_target_properties(FLINT::${name} PROPERTIES IMPORTED_LOCATION "${${prefix}_LIBRARY}"
                                                  INTERFACE_INCLUDE_DIRECTORIES "${${prefix}_INCLUDE_DIR}"
                                                  INTERFACE_LINK_LIBRARIES "${ARGN}")
endfunction()
if(FLINT_FOUND AND NOT TARGET FLINT::flint)
  flint_target(flint FLINT)
  flint_target(arb FLINT_ARB FLINT::flint)
  flint_target(calcium FLINT_CALCIUM FLINT::arb)
endif()
