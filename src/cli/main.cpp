#include <algorithm>
#include <exception>
#include <iomanip>
#include <iostream>
#include <string>
#include <vector>

#include "base/failure.h"
#include "base/old_name.h"
#include "cli/commands.h"
#include "cli/warnings.h"
#include "structure_from_wifi/input_error.h"
#include "structure_from_wifi/version.h"

namespace sfw {
namespace {

struct Command {
  const char* name;
  const char* purpose;
  void (*run)(Options&);
};

constexpr Command kCommands[] = {
    {"map", "Make a map from a recording, or maps from a list of them.", runMap},
    {"access-points",
     "Find the access points of a recording and print their table, to keep and to correct.",
     runAccessPoints},
    {"close-loops",
     "Correct the drift of odometry in a recording, where the robot returned to places that sound "
     "the same.",
     runCloseLoops},
    {"evaluate", "Compare a map with the truth and with a map made without radio.", runEvaluate},
    {"localise", "Find where scans were taken, on a radio map learned from located readings.",
     runLocalise},
    {"visibility", "Count the walls between an access point and every cell.", runVisibility},
    {"dense", "Find the walls from a full wall-count map: dense inverse k-visibility.", runDense},
    {"choose-sites", "Choose sites for access points in a known building and print their table.",
     runChooseSites},
    {"simulate", "Drive a simulated robot through a known building and record its readings.",
     runSimulate},
    {"next", "Rank the drives that a robot should make next, and draw them.", runNext},
    {"explore", "Let a simulated robot explore a known building by itself, and score its maps.",
     runExplore},
    {"bench",
     "Map many simulated recordings and print metrics beside references and ablations. After an "
     "interruption the same command resumes.",
     runBench},
    {"merge",
     "Put together what the shards of `sfw map --list` or `sfw bench` made. Checks that all are of "
     "one work list, and that no row is missing or double.",
     runMerge},
    {"fit", "Fit the belief model to simulated drives. The setting belief/model names its file.",
     runFit},
    {"wall-drives",
     "Simulate drives for the training of the network of walls. scripts/train_walls.py reads them.",
     runWallDrives},
};

constexpr char kOldChooseSites[] = "place";

void printHelp(std::ostream& out) {
  out << "Usage: sfw COMMAND OPTIONS\n\n"
         "Maps a building from odometry and WiFi signal strength.\n\nCommands:\n";
  for (const Command& command : kCommands) {
    const std::string purpose = command.purpose;
    out << "  " << std::left << std::setw(14) << command.name
        << purpose.substr(0, purpose.find(". ")) << (purpose.find(". ") < purpose.size() ? "." : "")
        << '\n';
  }
  out << "\n`sfw COMMAND --help` explains the options of a command; `sfw --version` prints the "
         "version.\n";
}

/// @throw InputError if there is no such subcommand
Command commandNamed(std::string name) {
  if (name == kOldChooseSites) {
    warn(oldNameWarning("sfw place", "sfw choose-sites"));
    name = "choose-sites";
  }
  const auto* const found = std::find_if(std::begin(kCommands), std::end(kCommands),
                                         [&](const Command& known) { return name == known.name; });
  if (found == std::end(kCommands)) {
    throw InputError("there is no subcommand '" + name + "'; see `sfw --help`");
  }
  return *found;
}

/// @throw InputError if the command line cannot be used, and as the subcommands
void run(const std::vector<std::string>& arguments) {
  if (arguments.empty()) {
    printHelp(std::cerr);
    throw InputError("a subcommand is missing; choose one of those above");
  }
  const std::string& first = arguments.front();
  if (first == "--help" || first == "-h") {
    printHelp(std::cout);
  } else if (first == "--version") {
    std::cout << "sfw " << version() << '\n';
  } else {
    const Command command = commandNamed(first);
    Options options(command.name, command.purpose, {arguments.begin() + 1, arguments.end()});
    command.run(options);
  }
  std::cout.flush();
  if (!std::cout) {
    throw InputError("standard output cannot be written");
  }
}

}  // namespace
}  // namespace sfw

int main(int argc, char** argv) {
  try {
    sfw::run({argv + std::min(argc, 1), argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "sfw: " << sfw::reasonOf(error) << '\n';
    return 1;
  }
  return 0;
}
