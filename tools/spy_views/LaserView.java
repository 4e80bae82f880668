package pico.spy;

import java.awt.geom.Path2D;
import java.io.IOException;
import java.util.List;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.lcm.LCMDataInputStream;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import pico.laser_scan_t;

/**
 * One sweep of the laser in the robot frame [m], x up: where the beams end, and what they saw as
 * free. Beams without a return, outside [valid_min, valid_max], are left out.
 */
public final class LaserView implements SpyPlugin {
  private static final Style FREE =
      Style.area("seen as free", Palette.SKY_BLUE, 0, Dash.NONE, Fill.TINT);
  private static final Style END = Style.mark("end of a beam", Palette.BLUE, Mark.DOT);
  private static final Style LASER = Style.mark("laser", Palette.VERMILION, Mark.BOX);
  private static final List<Style> LEGEND = List.of(END, FREE, LASER, Robot.STYLE);

  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == laser_scan_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new OpenView<>("Laser view", desktop, channel, LaserView::decode,
        () -> new SceneDisplay(LEGEND));
  }

  private static Scene decode(LCMDataInputStream bytes) throws IOException {
    return scene(new laser_scan_t(bytes));
  }

  private static Scene scene(laser_scan_t scan) {
    int returns = 0;
    for (float range : scan.ranges) returns += isReturn(scan, range) ? 1 : 0;
    Scene scene = new Scene(Scene.Up.X,
        Text.of("scan %d: %s, %d without a return from %.2f to %.2f m", scan.seq,
            Text.count(scan.num_ranges, "beam"), scan.num_ranges - returns, scan.valid_min,
            scan.valid_max));
    if (returns > 0) scene.shape(FREE, free(scan));
    for (int i = 0; i < scan.num_ranges; ++i) {
      if (!isReturn(scan, scan.ranges[i])) continue;
      scene.mark(END, endX(scan, i), endY(scan, i));
    }
    Robot.add(scene, 0, 0, 0);
    scene.mark(LASER, scan.laser_in_robot.x, scan.laser_in_robot.y);
    return scene;
  }

  /** From the laser along the ends; no return is unknown, never free. */
  private static Path2D free(laser_scan_t scan) {
    Path2D outline = new Path2D.Double();
    boolean open = false;
    for (int i = 0; i < scan.num_ranges; ++i) {
      boolean seen = isReturn(scan, scan.ranges[i]);
      if (seen && !open) outline.moveTo(scan.laser_in_robot.x, scan.laser_in_robot.y);
      if (seen) outline.lineTo(endX(scan, i), endY(scan, i));
      if (!seen && open) outline.closePath();
      open = seen;
    }
    if (open) outline.closePath();
    return outline;
  }

  private static boolean isReturn(laser_scan_t scan, float range) {
    return range > 0 && range >= scan.valid_min && range <= scan.valid_max;
  }

  private static double bearing(laser_scan_t scan, int beam) {
    double inLaser = scan.num_bearings > 0 ? scan.bearings[beam]
                                           : scan.angle_min + beam * scan.angle_increment;
    return scan.laser_in_robot.a + inLaser;
  }

  private static double endX(laser_scan_t scan, int beam) {
    return scan.laser_in_robot.x + scan.ranges[beam] * Math.cos(bearing(scan, beam));
  }

  private static double endY(laser_scan_t scan, int beam) {
    return scan.laser_in_robot.y + scan.ranges[beam] * Math.sin(bearing(scan, beam));
  }
}
