#include <algorithm>

#include "torse/cli/command.hpp"

int main(int argc, char** argv) {
  return torse::cli::run_program(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
}
