package pico.spy;

import java.io.IOException;
import javax.swing.Action;
import javax.swing.JDesktopPane;
import lcm.lcm.LCMDataInputStream;
import lcm.spy.ChannelData;
import lcm.spy.SpyPlugin;
import pico.status_t;

/**
 * How a component is doing: its inputs with their state and counts, its outputs, what it turned
 * down and why, its note, processing times [ms], memory [MB].
 */
public final class StatusView implements SpyPlugin {
  @Override
  public boolean canHandle(long fingerprint) {
    return fingerprint == status_t.LCM_FINGERPRINT;
  }

  @Override
  public Action getAction(JDesktopPane desktop, ChannelData channel) {
    return new OpenView<>("Status view", desktop, channel, StatusView::decode, StatusDisplay::new);
  }

  private static status_t decode(LCMDataInputStream bytes) throws IOException {
    return new status_t(bytes);
  }
}
