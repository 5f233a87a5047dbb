#include <exception>
#include <iostream>
#include <new>
#include <string>

#include "cli/commands.h"
#include "structure_from_wifi/version.h"

int main(int argc, char** argv) {
  CLI::App app{"Maps a building from odometry and WiFi signal strength.", "sfw"};
  app.set_version_flag("--version", std::string("sfw ") + sfw::version(),
                       "Print the version and exit");
  // Not `required`: that would be missed before a misspelt one is named.
  app.require_subcommand(0, 1);
  sfw::addMapCommand(app);
  sfw::addEvaluateCommand(app);
  sfw::addVisibilityCommand(app);
  sfw::addDenseCommand(app);
  sfw::addPlaceCommand(app);
  sfw::addSimulateCommand(app);
  sfw::addBenchCommand(app);
  sfw::addFitCommand(app);
  try {
    app.parse(argc, argv);
    if (app.get_subcommands().empty()) {
      std::cerr << "sfw: a subcommand is missing\n" << app.help();
      return 1;
    }
    std::cout.flush();
    if (!std::cout) {
      std::cerr << "sfw: standard output cannot be written\n";
      return 1;
    }
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 1;
  } catch (const std::bad_alloc&) {
    std::cerr << "sfw: out of memory; raise map/resolution or map a smaller area\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << "sfw: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
