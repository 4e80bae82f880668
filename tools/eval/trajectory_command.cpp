#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>

#include "common/bus/channels.hpp"
#include "common/runner/runner.hpp"
#include "common/time/stamp.hpp"
#include "tools/eval/command.hpp"
#include "tools/eval/log_tracks.hpp"
#include "tools/eval/read_events.hpp"
#include "tools/eval/trajectory_score.hpp"

namespace perceptor {
namespace {

struct TrajectoryOptions {
  std::filesystem::path log;
  std::filesystem::path reference;  ///< empty: none
  std::filesystem::path relations;  ///< empty: none
  std::filesystem::path out;        ///< empty: standard output
};

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }

Track read_longest_track(const std::filesystem::path& log) {
  TrackReader reader;
  read_events(log, [&](const LogEvent& event) { reader.take(event); });
  if (reader.undecodable() > 0)
    std::fprintf(stderr, "pico-eval: %lld LOCAL_MAP messages cannot be decoded\n",
                 static_cast<long long>(reader.undecodable()));
  const std::vector<Track> tracks = reader.tracks();
  if (tracks.empty())
    throw LogError(log.string() + " holds no good " + channel::local_map + " message");
  const Track& track = longest(tracks);
  if (tracks.size() > 1)
    std::fprintf(stderr, "pico-eval: %zu sessions or zero frames; the longest: %.1f s, %zu maps\n",
                 tracks.size(), duration(track), track.merge.size());
  return track;
}

void write(const Trajectory& trajectory, std::FILE* out) {
  for (const auto& [utime, pose] : trajectory)
    std::fprintf(out, "%.6f %.6f %.6f %.6f\n", seconds_between(0, utime), pose.x, pose.y, pose.a);
}

void write(const Trajectory& trajectory, const std::filesystem::path& file) {
  const std::unique_ptr<std::FILE, detail::CloseFile> out(std::fopen(file.c_str(), "w"));
  if (!out) throw LogError("cannot write " + file.string());
  write(trajectory, out.get());
  if (std::fflush(out.get()) != 0) throw LogError("cannot write " + file.string());
}

void print_row(std::FILE* out, const char* name, const DriftScore& score) {
  std::fprintf(out, "  %-10s %11.3f %12.4f %13.3f %14.4f\n", name, score.translation,
               score.translation_per_metre, degrees(score.heading),
               degrees(score.heading_per_metre));
}

void print_drift(std::FILE* out, const Track& track, const Trajectory& reference,
                 const TrajectoryScoreParameters& parameters) {
  const DriftScore merge = score_drift(track.merge, reference, parameters);
  const DriftScore odometry = score_drift(track.odometry, reference, parameters);
  std::fprintf(out,
               "drift over %g to %g m driven: %lld pairs of %lld reference poses, %lld skipped\n",
               parameters.min_path, parameters.max_path, static_cast<long long>(merge.pairs),
               static_cast<long long>(merge.poses), static_cast<long long>(merge.skipped));
  if (merge.pairs == 0) return;
  std::fprintf(out, "  %-10s %11s %12s %13s %14s\n", "", "transl. [m]", "[m/m]", "heading [deg]",
               "[deg/m]");
  print_row(out, "merge", merge);
  print_row(out, "odometry", odometry);
  if (odometry.translation == 0.0 || odometry.heading == 0.0) return;  // it is the reference
  std::fprintf(out, "  %-10s %11.3f %12s %13.3f\n", "ratio",
               merge.translation / odometry.translation, "", merge.heading / odometry.heading);
}

void print_row(std::FILE* out, const char* name, const RelationScore& score) {
  std::fprintf(out, "  %-10s %9.3f +- %6.3f %9.3f +- %6.3f\n", name, score.translation.mean,
               score.translation.sigma, degrees(score.rotation.mean),
               degrees(score.rotation.sigma));
}

void print_relations(std::FILE* out, const Track& track, const std::vector<Relation>& relations,
                     const TrajectoryScoreParameters& parameters) {
  const RelationScore merge = score_relations(track.merge, relations, parameters);
  const RelationScore odometry = score_relations(track.odometry, relations, parameters);
  std::fprintf(out, "relations: %lld, %lld skipped\n", static_cast<long long>(merge.relations),
               static_cast<long long>(merge.skipped));
  if (merge.skipped == merge.relations) return;
  std::fprintf(out, "  %-10s %19s %19s\n", "", "transl. [m]", "rotation [deg]");
  print_row(out, "merge", merge);
  print_row(out, "odometry", odometry);
}

int run_trajectory(const TrajectoryOptions& options) {
  // What is asked for is read before the log, so that a wrong file is told at once.
  Trajectory reference;
  if (!options.reference.empty()) reference = read_poses(options.reference);
  std::vector<Relation> relations;
  if (!options.relations.empty()) relations = read_relations(options.relations);
  const Track track = read_longest_track(options.log);

  std::FILE* table = stdout;
  if (options.out.empty()) {
    write(track.merge, stdout);
    table = stderr;
  } else {
    write(track.merge, options.out);
  }
  const TrajectoryScoreParameters parameters;
  if (!reference.empty()) print_drift(table, track, reference, parameters);
  if (!relations.empty()) print_relations(table, track, relations, parameters);
  return kExitOk;
}

}  // namespace

Command add_trajectory_command(CLI::App& app) {
  CLI::App* trajectory = app.add_subcommand(
      "trajectory", "where merge says that the robot was, scored beside odometry alone");
  const auto options = std::make_shared<TrajectoryOptions>();
  trajectory
      ->add_option("LOG", options->log,
                   "an LCM event log with LOCAL_MAP; of several sessions the longest counts")
      ->required();
  trajectory->add_option("--ref", options->reference,
                         "true poses, lines REF t x y theta: drift over 10 to 20 m driven");
  trajectory->add_option("--relations", options->relations,
                         "true relations, lines t1 t2 x y z roll pitch yaw, the pose at t2 seen\n"
                         "from that at t1: the mean absolute errors of Kuemmerle et al. (2009)");
  trajectory->add_option("--out", options->out,
                         "where t x y theta go [s, m, m, rad], a line for each local map; without\n"
                         "it to standard output, and the scores to standard error");
  trajectory->footer(
      "Both files may be gzipped; others are unpacked on the way (bash):\n"
      "  pico-eval trajectory out.lcmlog --ref <(xz -dc drive.ref.xz) --out drive.txt\n"
      "Poses are interpolated at the times of the reference; where the log has no local map, or\n"
      "none within 5 s, the reference is skipped and counted.");
  return {trajectory, [options] { return run_trajectory(*options); }};
}

}  // namespace perceptor
