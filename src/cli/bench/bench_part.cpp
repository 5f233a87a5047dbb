#include "cli/bench/bench_part.h"

#include <iostream>

#include "cli/bench/bench_store.h"
#include "cli/hash.h"
#include "files/atomic_file.h"
#include "files/text.h"
#include "structure_from_wifi/input_error.h"

namespace sfw {
namespace {

using Json = nlohmann::json;

BenchJob jobOf(const Json& row) {
  return {row.at("plan"), row.at("noise"), row.at("path"), row.at("seed")};
}

Json rowOf(std::size_t row, const BenchJob& job) {
  Json json = toJson(job);
  json["row"] = row;
  return json;
}

}  // namespace

Part partOf(const BenchReport& report, const BenchRun& run) {
  Part part;
  const std::vector<BenchJob> jobs = jobsOf(run.suite);
  part.rows = jobs.size();
  std::uint64_t recordings = hashOf("");
  for (const BenchJob& job : jobs) {
    recordings = hashOf(toText(job) + '\n', recordings);
  }
  part.work = workOf("bench");
  part.work["recordings"] = hexText(recordings);
  part.work["access_points"] = run.suite.access_points;
  part.work["methods"] = run.suite.methods;
  part.work["config"] = run.config_file.empty() ? "" : hexText(hashOf(readFile(run.config_file)));
  for (const BenchResult& result : report.results) {
    part.results.push_back(rowOf(result.row, result.job));
    part.results.back()["maps"] = result.maps;
  }
  for (const BenchFailure& failure : report.failures) {
    part.failures.push_back(rowOf(failure.row, failure.job));
    part.failures.back()["reason"] = failure.reason;
  }
  return part;
}

BenchReport reportOf(const Part& part) {
  BenchReport report;
  for (const Json& result : part.results) {
    report.results.push_back({result.at("row"), jobOf(result), result.at("maps")});
  }
  for (const Json& failure : part.failures) {
    report.failures.push_back({failure.at("row"), jobOf(failure), failure.at("reason")});
  }
  return report;
}

void requireNoFailure(const BenchReport& report) {
  std::vector<std::string> failures;
  for (const BenchFailure& failure : report.failures) {
    failures.push_back(toText(failure.job) + ": " + failure.reason);
  }
  requireNone(failures, report.failures.size() + report.results.size(),
              "failed, and the tables lack them");
}

void finishBench(const BenchReport& report, const std::string& directory) {
  const std::string table = toMarkdown(report);
  writeAtomically({{directory + "/bench.json", toJson(report)}, {directory + "/bench.md", table}});
  std::cout << table << std::flush;
  requireNoFailure(report);
}

}  // namespace sfw
