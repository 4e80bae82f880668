package pico.spy;

import java.awt.Color;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.Timer;

/** Under a view: what it shows, how long ago the last message came, and what went wrong. */
final class StatusLine extends JLabel {
  private static final int TICK_MS = 500;
  private static final double QUIET = 2.5;  // [s] without a message that is worth a word

  private final transient Timer timer = new Timer(TICK_MS, tick -> refresh());
  private String summary = "no message yet";
  private String complaint = "";
  private long last = System.nanoTime();

  StatusLine() {
    super(" ");
    putClientProperty("html.disable", true);  // what a message says is no markup
    setFont(Drawing.FONT);
    setBorder(BorderFactory.createEmptyBorder(3, 8, 3, 8));
    refresh();
    timer.start();
  }

  void say(String text) {
    summary = text;
    last = System.nanoTime();
    refresh();
  }

  void complain(String text) {
    complaint = text;
    refresh();
  }

  void stop() {
    timer.stop();
  }

  private void refresh() {
    double quiet = (System.nanoTime() - last) * 1e-9;
    String text = summary;
    if (quiet > QUIET) text += Text.of("; the last message came %.0f s ago", quiet);
    if (!complaint.isEmpty()) text = complaint + "; " + text;
    setForeground(complaint.isEmpty() ? Color.BLACK : Palette.VERMILION);
    setText(text);
    setToolTipText(text);  // where the line is too narrow
  }
}
