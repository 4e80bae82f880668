package pico.spy;

import java.awt.Component;
import java.awt.Dimension;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.DefaultTableModel;

/** A titled table whose rows are replaced as a whole: words to the left, numbers to the right. */
final class Sheet {
  private static final int ROW_HEIGHT = 20;
  private static final int WIDTH = 640;
  private static final int WORD_WIDTH = 200;

  private final DefaultTableModel model = new DefaultTableModel() {
    @Override
    public boolean isCellEditable(int row, int column) {
      return false;
    }
  };
  private final JScrollPane component;

  /** As high as so many rows; the first columns hold words and are wider. */
  Sheet(String title, int rows, int wordColumns, String... columns) {
    model.setColumnIdentifiers(columns);
    JTable table = new JTable(model);
    table.setFont(Drawing.FONT);
    table.setRowHeight(ROW_HEIGHT);
    table.setFillsViewportHeight(true);
    table.setPreferredScrollableViewportSize(new Dimension(WIDTH, rows * ROW_HEIGHT));
    for (int i = 0; i < wordColumns; ++i)
      table.getColumnModel().getColumn(i).setPreferredWidth(WORD_WIDTH);
    table.setDefaultRenderer(Object.class, new CellRenderer());
    component = new JScrollPane(table);
    component.setBorder(BorderFactory.createTitledBorder(title));
  }

  JComponent component() {
    return component;
  }

  /** Changes cells in place, so that a selection and the scroll bar stay. */
  void show(List<Object[]> rows) {
    model.setRowCount(rows.size());
    for (int row = 0; row < rows.size(); ++row) {
      for (int column = 0; column < rows.get(row).length; ++column)
        model.setValueAt(rows.get(row)[column], row, column);
    }
  }

  private static final class CellRenderer extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(JTable table, Object value, boolean selected,
        boolean focused, int row, int column) {
      putClientProperty("html.disable", true);  // what a message says is no markup
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      setHorizontalAlignment(value instanceof Number ? SwingConstants.RIGHT : SwingConstants.LEFT);
      setForeground(value instanceof InputState state ? state.colour : Palette.BLACK);
      return this;
    }
  }
}
