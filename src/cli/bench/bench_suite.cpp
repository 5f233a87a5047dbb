#include "cli/bench/bench_suite.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "base/validation.h"
#include "cli/floor_plan_files.h"
#include "evaluation/scoring_suite.h"
#include "simulation/radio/noise_level.h"
#include "simulation/robot/route_planner.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

constexpr char kKeys[] = "plans, generate, levels, paths, seeds, access_points, methods";

/// Names in a suite file are relative to it.
std::string relativeTo(const std::string& suite_file, const std::string& name) {
  return (fs::path(suite_file).parent_path() / name).lexically_normal().string();
}

void readValue(const std::string& file, const std::string& key, const YAML::Node& value,
               BenchSuite& suite) {
  using Names = std::vector<std::string>;
  if (key == "plans") {
    suite.plans = value.as<Names>();
    for (std::string& plan : suite.plans) {
      plan = relativeTo(file, plan);
    }
  } else if (key == "paths") {
    suite.paths = value.as<Names>();
    for (std::string& path : suite.paths) {
      path = parseRouteKind(path) ? path : relativeTo(file, path);
    }
  } else if (key == "levels") {
    suite.levels = value.as<Names>();
  } else if (key == "methods") {
    suite.methods = value.as<Names>();
  } else if (key == "generate") {
    suite.generate = value.as<std::int64_t>();
  } else if (key == "seeds") {
    suite.seeds = value.as<std::int64_t>();
  } else if (key == "access_points") {
    suite.access_points = value.as<std::int64_t>();
  } else {
    throw InputError(file + ": there is no key '" + key + "'; the keys are " + kKeys);
  }
}

std::vector<std::string> plansOf(const BenchSuite& suite) {
  std::vector<std::string> plans = floorPlanFiles(suite.plans);
  for (std::int64_t i = 1; i <= suite.generate; ++i) {
    plans.push_back("generated " + std::to_string(i));
  }
  return plans;
}

void requireUsable(const BenchSuite& suite) {
  Problems problems;
  const auto collect = [&](auto&& may_throw) {
    try {
      may_throw();
    } catch (const InputError& error) {
      problems.add(error.what());
    }
  };
  const auto within = [&](const char* name, std::int64_t value, double low, double high) {
    problems.within(name, static_cast<double>(value), low, high);
  };
  constexpr double kMost = 10000.0;
  for (const std::string& level : suite.levels) {
    collect([&] { noiseLevel(level); });
  }
  collect([&] { benchmarkMethods(suite.methods); });
  for (const std::string& path : suite.paths) {
    if (!parseRouteKind(path) && !fs::exists(path)) {
      problems.add("paths: '" + path + "' is neither walls nor sparse, nor a file of way points");
    }
  }
  for (const std::string& plan : suite.plans) {
    if (!fs::exists(plan)) {
      problems.add(plan + ": the plan does not exist");
    }
  }
  if (suite.levels.empty()) {
    problems.add("levels must name at least one level");
  }
  if (suite.paths.empty()) {
    problems.add("paths must name at least one path");
  }
  within("generate", suite.generate, 0.0, kMost);
  within("seeds", suite.seeds, 1.0, kMost);
  within("access_points", suite.access_points, 1.0, 100.0);
  problems.throwIfAny();
}

}  // namespace

BenchSuite readBenchSuite(const std::string& file) {
  BenchSuite suite;
  try {
    const YAML::Node root = YAML::LoadFile(file);
    if (!root.IsMap()) {
      throw InputError(file + ": a suite must be a map with some of the keys " + kKeys);
    }
    for (const auto& entry : root) {
      const auto key = entry.first.as<std::string>();
      try {
        readValue(file, key, entry.second, suite);
      } catch (const YAML::Exception&) {
        throw InputError(file + ": " + key + " has the wrong type");
      }
    }
  } catch (const YAML::BadFile&) {
    throw InputError(file + ": cannot be read");
  } catch (const YAML::Exception& error) {
    throw InputError(file + ": " + error.what());
  }
  return suite;
}

std::vector<BenchJob> jobsOf(const BenchSuite& suite) {
  requireUsable(suite);
  std::vector<BenchJob> jobs;
  for (const std::string& plan : plansOf(suite)) {
    for (const std::string& level : suite.levels) {
      for (const std::string& path : suite.paths) {
        for (std::int64_t seed = 1; seed <= suite.seeds; ++seed) {
          jobs.push_back({plan, level, path, seed});
        }
      }
    }
  }
  if (jobs.empty()) {
    throw InputError(
        "there is no plan: give --plan or --generate, or plans or generate in --suite");
  }
  return jobs;
}

std::string toText(const BenchJob& job) {
  return job.plan + ", " + job.level + ", " + job.path + ", seed " + std::to_string(job.seed);
}

}  // namespace sfw
