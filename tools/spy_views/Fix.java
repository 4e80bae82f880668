package pico.spy;

import pico.pose_t;
import pico.position_t;
import pico.world_position_t;

/**
 * Where the robot was at utime [us].
 *
 * @param origin names the frame: another value is another frame, and a way of its own
 * @param pose null where there is none, not even a guess
 * @param certain a claimed pose, not a guess
 * @param covariance rows x, y, a [m^2, m rad, rad^2]; null where it is not known
 */
record Fix(long utime, long session, long origin, pose_t pose, boolean certain,
           double[] covariance, String summary) {

  static Fix of(position_t position) {
    String bridged = position.bridged == 0 ? "" : ", " + Text.count(position.bridged, "jump")
        + " bridged";
    return new Fix(position.utime, position.session, position.zero_utime, position.robot_in_zero,
        true, null, text(position.robot_in_zero) + " in the zero frame" + bridged);
  }

  static Fix of(world_position_t position) {
    boolean tracking = position.state == world_position_t.TRACKING;
    String state = switch (position.state) {
      case world_position_t.SEARCHING -> "searching";
      case world_position_t.TRACKING -> "tracking";
      case world_position_t.LOST -> "lost";
      default -> "state " + position.state;
    };
    boolean somewhere = tracking || position.guessed;
    String where = somewhere ? text(position.robot_in_world) + " in the world frame" : "no pose";
    return new Fix(position.utime, position.session, position.map_id,
        somewhere ? position.robot_in_world : null, tracking,
        tracking ? position.covariance : null,
        state + (position.ambiguous ? ", ambiguous" : "") + ": " + where);
  }

  private static String text(pose_t pose) {
    return Text.of("x %.2f m, y %.2f m, a %.1f deg", pose.x, pose.y, Math.toDegrees(pose.a));
  }
}
