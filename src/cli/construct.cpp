// torse construct: a developable surface through a curve, verified before it is written.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "torse/cli/command.hpp"
#include "torse/cli/construct_methods.hpp"
#include "torse/cli/conversion.hpp"
#include "torse/cli/effort.hpp"
#include "torse/cli/judge.hpp"
#include "torse/cli/suggest.hpp"
#include "torse/cli/terminal.hpp"
#include "torse/io/file.hpp"
#include "torse/io/text.hpp"

namespace torse::cli {
namespace {

struct ConstructOptions {
  std::string method;
  std::string input;
  std::string output;
  int branch = 1;
};

std::vector<std::string> method_names() {
  std::vector<std::string> names;
  for (const MethodKeys& keys : method_keys()) names.emplace_back(keys.method);
  return names;
}

void require_method(const std::string& method) {
  for (const std::string& name : method_names()) {
    if (name == method) return;
  }
  throw UsageError(fmt::format("unknown method {}{} (methods: {})", in_quotes(method),
                               suggestion(method, method_names()), fmt::join(method_names(), ", ")));
}

Construction run_method(const ConstructOptions& options) {
  const Document document(options.input, read_file(options.input));
  const ConstructFile<Rational> input = read_construct<Rational>(document);
  if (input.method != options.method) {
    document.root().at("method").expected("the method of the command line, \"" + options.method + '"');
  }
  try {
    return construct_surface(input, options.branch);
  } catch (const InvalidInput& invalid) {
    throw document.error(invalid);
  } catch (const NoSolution& none) {
    throw NoSolution(printable(options.input) + ": " + none.what());
  }
}

int run_construct(const ConstructOptions& options) {
  require_method(options.method);
  require_json_name("--output", options.output);
  std::vector<std::string> words{"torse", "construct", options.method, file_word(options.input), "-o", options.output};
  if (options.branch != 1) words.insert(words.end(), {"--branch", std::to_string(options.branch)});
  const std::string replay = printable(command_line(words));
  const Terminal terminal(options.output == "-" ? stderr : stdout);
  try {
    const Construction result = run_method(options);
    require_effort(options.input, result.surface, "a result");
    const Judgement judgement = judge(result.surface);
    for (const std::string& note : result.notes) terminal.print(note + '\n');
    if (!judgement.developable()) {
      print_error("the exact decision refutes the result, nothing is written: " +
                  describe(*judgement.witness, result.surface.knots) + "\n  replay: " + replay);
      return exit_code::refuted;
    }
    write_file(options.output, write_ruled(result.surface));
    terminal.print(fmt::format("{}: {}, decided exactly; {}\n",
                               options.output == "-" ? "standard output" : printable(options.output),
                               terminal.painted(Paint::good, "developable"), describe(judgement.classification)));
    return exit_code::success;
  } catch (const NoSolution& none) {
    print_error(std::string(none.what()) + "\n  replay: " + replay);
    return exit_code::refuted;
  } catch (const FileError& error) {
    print_error(std::string(error.what()) + "\n  replay: " + replay);
    return exit_code::unusable;
  }
}

}  // namespace

std::function<int()> define_construct(CLI::App& app) {
  const auto options = std::make_shared<ConstructOptions>();
  app.add_option("METHOD", options->method, fmt::format("{}", fmt::join(method_names(), ", ")))->required();
  app.add_option("INPUT", options->input, "the curve and the parameters, torse's JSON; - is standard input")
      ->required();
  app.add_option("-o,--output", options->output, "the ruled surface to write; - is standard output")
      ->type_name("FILE")
      ->required();
  app.add_option("--branch", options->branch, "which solution of interpolate to write")->capture_default_str();
  return [options] { return run_construct(*options); };
}

}  // namespace torse::cli
