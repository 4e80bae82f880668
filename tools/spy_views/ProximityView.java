package pico.spy;

import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.io.IOException;
import java.util.List;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.lcm.LCMDataInputStream;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import pico.proximity_t;

/**
 * The sectors around the robot [m], x up: how far each is free, up to twice the radius; too close,
 * blind and touching ones told apart; the nearest thing in each, and the nearest of all.
 */
public final class ProximityView implements SpyPlugin {
  private static final double REACH = 2;  // radii that are drawn
  private static final double TOUCH = 1;  // radii that a blind or touching sector is drawn with
  private static final double FINE = Math.toRadians(2);

  private static final Style CLEAR =
      Style.area("free up to there", Palette.GREEN, 0.5, Dash.NONE, Fill.TINT);
  private static final Style TOO_CLOSE =
      Style.area("too close", Palette.VERMILION, 1, Dash.NONE, Fill.SOLID);
  private static final Style CONTACT =
      Style.area("touches the robot", Palette.BLACK, 2, Dash.NONE, Fill.CROSS_HATCH);
  private static final Style BLIND =
      Style.area("blind", Palette.ORANGE, 0.5, Dash.NONE, Fill.HATCH);
  private static final Style RADIUS = Style.line("radius", Palette.BLUE, 2, Dash.DASHES);
  private static final Style SEEN = Style.mark("nearest in a sector", Palette.BLUE, Mark.DISC);
  private static final Style NEAREST = Style.mark("nearest of all", Palette.PURPLE, Mark.DIAMOND);
  private static final List<Style> LEGEND =
      List.of(CLEAR, TOO_CLOSE, CONTACT, BLIND, RADIUS, SEEN, NEAREST, Robot.STYLE);

  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == proximity_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new OpenView<>("Proximity view", desktop, channel, ProximityView::decode,
        () -> new SceneDisplay(LEGEND));
  }

  private static Scene decode(LCMDataInputStream bytes) throws IOException {
    return scene(new proximity_t(bytes));
  }

  private static Scene scene(proximity_t proximity) {
    Scene scene = new Scene(Scene.Up.X, summary(proximity));
    double reach = REACH * proximity.radius;
    for (int i = 0; i < proximity.num_sectors; ++i)
      scene.shape(style(proximity, i), wedge(proximity, i));
    double radius = proximity.radius;
    scene.shape(RADIUS, new Ellipse2D.Double(-radius, -radius, 2 * radius, 2 * radius));
    for (int i = 0; i < proximity.num_sectors; ++i) {
      if (proximity.distances[i] <= reach)
        mark(scene, SEEN, proximity.distances[i], proximity.bearings[i]);
    }
    if (proximity.nearest_distance <= reach)
      mark(scene, NEAREST, proximity.nearest_distance, proximity.nearest_bearing);
    Robot.add(scene, 0, 0, 0);
    return scene;
  }

  private static String summary(proximity_t proximity) {
    return Text.of("scan %d: %d of %d sectors too close, %d blind, %d touching; nearest %.2f m at"
            + " %.0f deg; radius %.2f m",
        proximity.seq, count(proximity.too_close), proximity.num_sectors, count(proximity.blind),
        count(proximity.contact), proximity.nearest_distance,
        Math.toDegrees(proximity.nearest_bearing), proximity.radius);
  }

  private static int count(boolean[] flags) {
    int set = 0;
    for (boolean flag : flags) set += flag ? 1 : 0;
    return set;
  }

  private static Style style(proximity_t proximity, int sector) {
    if (proximity.contact[sector]) return CONTACT;
    if (proximity.too_close[sector]) return TOO_CLOSE;
    return proximity.blind[sector] ? BLIND : CLEAR;
  }

  private static Path2D wedge(proximity_t proximity, int sector) {
    double width = 2 * Math.PI / proximity.num_sectors;
    double from = -Math.PI + sector * width;
    double length = length(proximity, sector);
    int steps = Math.max(1, (int) Math.ceil(width / FINE));
    Path2D path = new Path2D.Double();
    path.moveTo(0, 0);
    for (int i = 0; i <= steps; ++i) {
      double bearing = from + width * i / steps;
      path.lineTo(length * Math.cos(bearing), length * Math.sin(bearing));
    }
    path.closePath();
    return path;
  }

  private static double length(proximity_t proximity, int sector) {
    boolean reaches = !proximity.contact[sector]
        && (proximity.too_close[sector] || !proximity.blind[sector]);
    return reaches ? Math.min(proximity.distances[sector], REACH * proximity.radius)
                   : TOUCH * proximity.radius;
  }

  private static void mark(Scene scene, Style style, double distance, double bearing) {
    scene.mark(style, distance * Math.cos(bearing), distance * Math.sin(bearing));
  }
}
