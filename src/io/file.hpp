// Whole files.
//   read_file        the bytes of a file, "-" for the standard input
//   write_file       all or nothing, "-" for the standard output
//   make_folder      a folder to write into
#pragma once

#include <string>
#include <string_view>

#include "torse/io/document.hpp"

namespace torse {

/// The bytes of a file of at most limits::file_bytes. Throws FileError.
std::string read_file(const std::string& path);

/// Writes a file: a temporary file in the same folder takes the place of the old one when it is complete, so that an
/// error leaves the old file, or none. What is not a regular file (a device, a pipe) is written directly. Throws
/// FileError.
void write_file(const std::string& path, std::string_view content);

/// Makes the folder and those above it, unless they are there. Throws FileError.
void make_folder(const std::string& path);

}  // namespace torse
