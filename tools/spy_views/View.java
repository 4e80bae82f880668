package pico.spy;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.beans.PropertyVetoException;
import java.io.IOException;
import java.util.regex.Pattern;
import javax.swing.JDesktopPane;
import javax.swing.JFrame;
import javax.swing.JInternalFrame;
import javax.swing.SwingUtilities;
import javax.swing.event.InternalFrameAdapter;
import javax.swing.event.InternalFrameEvent;
import lcm.lcm.LCM;
import lcm.lcm.LCMDataInputStream;
import lcm.lcm.LCMDataOutputStream;
import lcm.lcm.LCMEncodable;
import lcm.spy.ChannelData;

/** A frame with a display that follows one channel until the frame is closed. */
final class View<T> {
  private static final Dimension WINDOW = new Dimension(760, 620);

  private final ChannelData channel;
  private final String subscription;
  private final Feed<T> feed;
  private final JInternalFrame frame;
  private final StatusLine status = new StatusLine();

  View(String name, ChannelData channel, Decoder<T> decoder, Display<T> display) {
    this.channel = channel;
    subscription = Pattern.quote(channel.name);
    feed = new Feed<>(decoder, newest -> {
      display.show(newest);
      status.say(display.summary(newest));
    }, status::complain);
    frame = new JInternalFrame(channel.name + ": " + name, true, true, true, true);
    frame.add(display.component(), BorderLayout.CENTER);
    frame.add(status, BorderLayout.SOUTH);
    frame.setSize(WINDOW);
  }

  void open(JDesktopPane desktop) {
    JFrame window = ownWindow(desktop);
    frame.addInternalFrameListener(new InternalFrameAdapter() {
      @Override
      public void internalFrameClosed(InternalFrameEvent event) {
        close(window);
      }
    });
    desktop.add(frame);
    if (window != null) fill(window);
    frame.setVisible(true);
    showLast();
    LCM.getSingleton().subscribe(subscription, feed);
  }

  /** lcm-spy 1.3 makes a window for each view; older ones have one desktop for all. */
  private JFrame ownWindow(JDesktopPane desktop) {
    boolean own = desktop.getAllFrames().length == 0
        && SwingUtilities.getWindowAncestor(desktop) instanceof JFrame window
        && window.getTitle().equals(channel.name);
    return own ? (JFrame) SwingUtilities.getWindowAncestor(desktop) : null;
  }

  /** Closing the window only hides it, and the view would go on unseen. */
  private void fill(JFrame window) {
    window.addWindowListener(new WindowAdapter() {
      @Override
      public void windowClosing(WindowEvent event) {
        frame.dispose();
      }
    });
    window.setSize(WINDOW);
    window.validate();
    try {
      frame.setMaximum(true);
    } catch (PropertyVetoException e) {
      // It stays as large as it is.
    }
  }

  /** So that a slow channel, or a log that has ended, shows something at once. */
  private void showLast() {
    if (!(channel.last instanceof LCMEncodable last)) return;
    LCMDataOutputStream bytes = new LCMDataOutputStream();
    try {
      last.encode(bytes);
    } catch (IOException | RuntimeException e) {
      return;  // the next message will do
    }
    feed.messageReceived(null, channel.name, new LCMDataInputStream(bytes.toByteArray()));
  }

  private void close(JFrame window) {
    LCM.getSingleton().unsubscribe(subscription, feed);
    status.stop();
    if (window != null) window.dispose();
  }
}
