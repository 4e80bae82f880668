package pico.spy;

import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMSubscriber;

/**
 * Decodes messages on LCM's thread and hands the newest to the Swing thread: whoever draws slower
 * than messages come skips some. No message throws into LCM, whose thread would end.
 */
final class Feed<T> implements LCMSubscriber {
  private final Decoder<T> decoder;
  private final Consumer<T> show;
  private final Consumer<String> complain;
  private final AtomicReference<T> newest = new AtomicReference<>();
  private final AtomicReference<String> complaint = new AtomicReference<>();
  private long failures;

  /** Both consumers are called on the Swing thread. */
  Feed(Decoder<T> decoder, Consumer<T> show, Consumer<String> complain) {
    this.decoder = decoder;
    this.show = show;
    this.complain = complain;
  }

  @Override
  public synchronized void messageReceived(LCM lcm, String channel, LCMDataInputStream bytes) {
    try {
      T decoded = decoder.decode(bytes);
      if (bytes.available() > 0) fail(bytes.available() + " bytes too many");
      if (decoded != null) hand(newest, decoded, show);
    } catch (Exception | OutOfMemoryError e) {
      fail(e.getClass().getSimpleName() + ": " + e.getMessage());
    }
  }

  private void fail(String reason) {
    ++failures;
    hand(complaint, failures + " not decoded; " + reason, complain);
  }

  private static <V> void hand(AtomicReference<V> waiting, V value, Consumer<V> consumer) {
    if (waiting.getAndSet(value) != null) return;
    SwingUtilities.invokeLater(() -> consumer.accept(waiting.getAndSet(null)));
  }
}
