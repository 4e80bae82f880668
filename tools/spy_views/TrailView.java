package pico.spy;

import java.io.IOException;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.lcm.LCMDataInputStream;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import pico.position_t;
import pico.world_position_t;

/**
 * Where the robot is and was [m]: POSITION in the zero frame, x up; WORLD_POSITION in the world
 * frame, y up, with guesses told apart and how certain a claimed pose is.
 */
public final class TrailView implements SpyPlugin {
  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == position_t.LCM_FINGERPRINT
        || fingerprint == world_position_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    Trail trail = new Trail();
    return new OpenView<>("Trail view", desktop, channel, bytes -> decode(bytes, trail),
        () -> new SceneDisplay(Trail.LEGEND));
  }

  private static Scene decode(LCMDataInputStream bytes, Trail trail) throws IOException {
    long fingerprint = bytes.readLong();
    bytes.reset();
    return fingerprint == position_t.LCM_FINGERPRINT
        ? trail.add(Fix.of(new position_t(bytes)), Scene.Up.X)
        : trail.add(Fix.of(new world_position_t(bytes)), Scene.Up.Y);
  }
}
