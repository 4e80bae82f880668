package pico.spy;

import java.awt.BorderLayout;
import java.awt.Font;
import java.awt.GridLayout;
import java.util.Arrays;
import java.util.Collections;
import javax.swing.BorderFactory;
import javax.swing.Box;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import pico.status_t;

/** One component's status in tables. */
final class StatusDisplay implements Display<status_t> {
  private final JPanel panel = new JPanel(new BorderLayout());
  private final JLabel heading = new JLabel(" ");
  private final JLabel note = new JLabel(" ");
  private final Sheet inputs = new Sheet("Inputs", 5, 1, "channel", "state", "received", "rejected",
      "missed", "restarts");
  private final Sheet outputs = new Sheet("Outputs", 4, 1, "channel", "published", "last seq");
  private final Sheet rejects = new Sheet("Rejected", 6, 2, "channel", "reason", "count");
  private final Sheet effort = new Sheet("Effort", 1, 0, "processed", "p50 [ms]", "p99 [ms]",
      "max [ms]", "memory [MB]", "processor [s]");

  StatusDisplay() {
    heading.setFont(Drawing.FONT.deriveFont(Font.BOLD, 15f));
    note.setFont(Drawing.FONT);
    for (JLabel label : new JLabel[] {heading, note})
      label.putClientProperty("html.disable", true);  // what a message says is no markup
    JPanel top = new JPanel(new GridLayout(2, 1));
    top.setBorder(BorderFactory.createEmptyBorder(6, 8, 6, 8));
    top.add(heading);
    top.add(note);
    Box tables = Box.createVerticalBox();
    for (Sheet sheet : new Sheet[] {effort, inputs, outputs, rejects})
      tables.add(sheet.component());
    panel.add(top, BorderLayout.NORTH);
    panel.add(tables, BorderLayout.CENTER);
  }

  @Override
  public JComponent component() {
    return panel;
  }

  @Override
  public void show(status_t status) {
    String state = (status.degraded ? ", degraded" : "") + (status.last ? ", stopped" : "");
    heading.setText(status.component + " " + status.version + state);
    heading.setForeground(state.isEmpty() ? Palette.BLACK : Palette.VERMILION);
    note.setText(status.note.isEmpty() ? "no note" : status.note);
    inputs.show(Arrays.stream(status.inputs)
        .map(input -> new Object[] {input.channel, InputState.of(input), input.received,
            input.rejected, input.missed, input.restarts})
        .toList());
    outputs.show(Arrays.stream(status.outputs)
        .map(output -> new Object[] {output.channel, output.published,
            output.last_seq < 0 ? "none yet" : output.last_seq})
        .toList());
    rejects.show(Arrays.stream(status.rejects)
        .map(reject -> new Object[] {reject.channel, reject.reason, reject.count})
        .toList());
    effort.show(Collections.singletonList(new Object[] {status.processed,
        Text.rounded(status.p50_us / 1000, 3), Text.rounded(status.p99_us / 1000, 3),
        Text.rounded(status.max_us / 1000, 3), Text.rounded(status.rss_bytes / 1e6, 1),
        Text.rounded(status.cpu_s, 1)}));
  }

  @Override
  public String summary(status_t status) {
    return Text.of("status %d: %s", status.seq,
        Text.count(status.processed, "message") + " processed");
  }
}
