#include "cli/bench/bench_suite.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <filesystem>

#include "cli/plan_files.h"
#include "evaluation/scoring_suite.h"
#include "simulation/radio/noise_level.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

namespace fs = std::filesystem;

constexpr char kKeys[] = "plans, generate, levels, paths, seeds, access_points, methods";

bool isRouteKind(const std::string& path) { return path == "walls" || path == "sparse"; }

/// Names in a suite file are relative to it.
std::string beside(const std::string& suite_file, const std::string& name) {
  return (fs::path(suite_file).parent_path() / name).lexically_normal().string();
}

void readValue(const std::string& file, const std::string& key, const YAML::Node& value,
               BenchSuite& suite) {
  using Names = std::vector<std::string>;
  if (key == "plans") {
    suite.plans = value.as<Names>();
    for (std::string& plan : suite.plans) {
      plan = beside(file, plan);
    }
  } else if (key == "paths") {
    suite.paths = value.as<Names>();
    for (std::string& path : suite.paths) {
      path = isRouteKind(path) ? path : beside(file, path);
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
    throw InputError(file + ": there is no '" + key + "'; there are: " + kKeys);
  }
}

std::vector<std::string> plansOf(const BenchSuite& suite) {
  std::vector<std::string> plans = planFiles(suite.plans);
  for (std::int64_t i = 1; i <= suite.generate; ++i) {
    plans.push_back("generated " + std::to_string(i));
  }
  return plans;
}

void requireUsable(const BenchSuite& suite) {
  std::string problems;
  const auto check = [&](bool good, const std::string& problem) {
    problems += good ? "" : (problems.empty() ? "" : "\n") + problem;
  };
  const auto tell = [&](auto&& may_throw) {
    try {
      may_throw();
    } catch (const InputError& error) {
      check(false, error.what());
    }
  };
  constexpr std::int64_t kMost = 10000;
  for (const std::string& level : suite.levels) {
    tell([&] { parseNoiseLevel(level); });
  }
  tell([&] { benchmarkMethods(suite.methods); });
  for (const std::string& path : suite.paths) {
    check(isRouteKind(path) || fs::exists(path),
          "paths: '" + path + "' is neither walls nor sparse, nor a file of way points");
  }
  for (const std::string& plan : suite.plans) {
    check(fs::exists(plan), plan + ": there is no such plan");
  }
  check(!suite.levels.empty(), "levels must name one");
  check(!suite.paths.empty(), "paths must name one");
  check(suite.generate >= 0 && suite.generate <= kMost, "generate must lie in 0..10000");
  check(suite.seeds >= 1 && suite.seeds <= kMost, "seeds must lie in 1..10000");
  check(suite.access_points >= 1 && suite.access_points <= 100, "access_points must lie in 1..100");
  if (!problems.empty()) {
    throw InputError(problems);
  }
}

}  // namespace

BenchSuite readBenchSuite(const std::string& file) {
  BenchSuite suite;
  try {
    const YAML::Node root = YAML::LoadFile(file);
    if (!root.IsMap()) {
      throw InputError(file + ": must be a table with some of: " + kKeys);
    }
    for (const auto& entry : root) {
      const auto key = entry.first.as<std::string>();
      try {
        readValue(file, key, entry.second, suite);
      } catch (const YAML::Exception&) {
        throw InputError(file + ": " + key + " is of a wrong type");
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
