package enlightenment.window;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import javax.swing.JComponent;

/**
 * Component that shows a picture as large as fits. Small pictures are magnified by a whole factor, so that their pixels stay square; large ones are
 * reduced. For the event dispatch thread of Swing only.
 */
final class PictureCanvas extends JComponent {
    private static final long serialVersionUID = 1L;
    private static final int MOST_TIMES = 32;
    private static final Color AROUND = new Color(0x20, 0x20, 0x20);

    /** The share of the screen that a window initially takes. */
    private static final double SHARE = 0.6;

    private transient BufferedImage image;

    /**
     * @param width width of the expected pictures, in pixels
     * @param height height of the expected pictures, in pixels
     * @param screen bounds of the screen that windows may use
     */
    PictureCanvas(int width, int height, Rectangle screen) {
        image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        double fitting = Math.min(SHARE * screen.width / width, SHARE * screen.height / height);
        setZoom(Math.min(fitting < 1 ? Math.min(1, fitting / SHARE * 0.9) : Math.floor(fitting), MOST_TIMES));
    }

    /** Sets the preferred size to that of the picture, scaled by a factor. */
    private void setZoom(double times) {
        setPreferredSize(new Dimension(
                Math.max((int) Math.round(times * image.getWidth()), 1),
                Math.max((int) Math.round(times * image.getHeight()), 1)));
    }

    /** Sets the preferred size one zoom step larger or smaller than the shown picture. */
    void zoom(boolean larger) {
        double times = times();
        double next = larger ? Math.floor(times) + 1 : times > 1 ? Math.ceil(times) - 1 : times / 2;
        setZoom(Math.min(larger && times < 1 ? Math.min(2 * times, 1) : next, MOST_TIMES));
    }

    /** @param argb pixels of the picture, as of {@code Image.toArgb} */
    void show(int width, int height, int[] argb) {
        if (width != image.getWidth() || height != image.getHeight()) {
            image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        }
        int[] pixels = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        System.arraycopy(argb, 0, pixels, 0, pixels.length);
        repaint();
    }

    private double times() {
        double fitting = Math.min((double) getWidth() / image.getWidth(), (double) getHeight() / image.getHeight());
        return fitting < 1 ? fitting : Math.floor(fitting);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics;
        g.setColor(AROUND);
        g.fillRect(0, 0, getWidth(), getHeight());
        double times = times();
        int width = Math.max((int) Math.round(times * image.getWidth()), 1);
        int height = Math.max((int) Math.round(times * image.getHeight()), 1);
        g.setRenderingHint(
                RenderingHints.KEY_INTERPOLATION,
                times < 1
                        ? RenderingHints.VALUE_INTERPOLATION_BILINEAR
                        : RenderingHints.VALUE_INTERPOLATION_NEAREST_NEIGHBOR);
        g.drawImage(image, (getWidth() - width) / 2, (getHeight() - height) / 2, width, height, null);
    }
}
