package pico.spy;

import java.io.IOException;
import java.util.List;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.lcm.LCMDataInputStream;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import pico.map_t;

/**
 * A map [m] with all its parts: walls, corners by what they are, doors, cabinets, obstacles, and
 * where the robot stands. x is up, but in the world frame y is.
 */
public final class MapView implements SpyPlugin {
  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == map_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    MapParts parts = new MapParts();
    return new OpenView<>("Map view", desktop, channel, bytes -> decode(bytes, parts),
        () -> new SceneDisplay(MapStyles.LEGEND));
  }

  private static Scene decode(LCMDataInputStream bytes, MapParts parts) throws IOException {
    List<map_t> map = parts.add(new map_t(bytes));
    return map.isEmpty() ? null : MapScene.of(map);
  }
}
