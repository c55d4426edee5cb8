package enlightenment.window;

import enlightenment.image.Image;
import enlightenment.status.State;
import enlightenment.status.Status;
import enlightenment.status.StatusSource;
import java.awt.AWTError;
import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.awt.HeadlessException;
import java.awt.RadialGradientPaint;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.Closeable;
import java.lang.reflect.InvocationTargetException;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

/**
 * A window with the picture of a running render, and its progress in the title. A thread polls the render a few times a second and converts its
 * picture for the screen, large pictures less often.
 */
public final class PictureWindow implements Closeable {
    private static final long PERIOD_MILLIS = 250;

    /** The largest share of a processor for converting pictures. */
    private static final double SHARE = 0.02;

    private static final long PATIENCE_MILLIS = 200;
    private static final long SHORTAGE_NANOS = 10_000_000_000L;

    private final StatusSource source;
    private final Runnable whenClosed;
    private final CountDownLatch closed = new CountDownLatch(1);
    private JFrame frame;
    private PictureCanvas canvas;

    /** Number of the shown picture, as {@link Status#picture()}. */
    private long shown;

    private boolean isLast;
    private long tookNanos = Long.MAX_VALUE;
    private long nextNanos = System.nanoTime();

    private PictureWindow(StatusSource source, Runnable whenClosed) {
        this.source = source;
        this.whenClosed = whenClosed;
    }

    /**
     * Opens a window.
     *
     * @param width width of the pictures, in pixels
     * @param height height of the pictures, in pixels
     * @param whenClosed called after the user has closed the window
     * @throws NoDisplayException if there is no display, or this Java has no support for it
     */
    public static PictureWindow open(StatusSource source, int width, int height, Runnable whenClosed)
            throws NoDisplayException {
        PictureWindow window = new PictureWindow(source, whenClosed);
        try {
            if (GraphicsEnvironment.isHeadless()) {
                throw new HeadlessException();
            }
            SwingUtilities.invokeAndWait(() -> window.build(width, height));
        } catch (HeadlessException | AWTError | LinkageError e) {
            throw new NoDisplayException(e);
        } catch (InvocationTargetException e) {
            if (e.getCause() instanceof OutOfMemoryError error) {
                throw error;
            }
            throw new NoDisplayException(e.getCause());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new NoDisplayException(e);
        }
        Thread looking = new Thread(window::look, "window");
        looking.setDaemon(true);
        looking.start();
        return window;
    }

    private void build(int width, int height) {
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        canvas = new PictureCanvas(width, height, screen);
        frame = new JFrame(title(source.status()));
        frame.setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
        frame.setIconImage(icon());
        frame.add(canvas);
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                frame.dispose();
                closed.countDown();
                whenClosed.run();
            }
        });
        frame.addKeyListener(new KeyAdapter() {
            @Override
            public void keyTyped(KeyEvent e) {
                if (e.getKeyChar() == '+' || e.getKeyChar() == '-') {
                    canvas.zoom(e.getKeyChar() == '+');
                    frame.pack();
                }
            }
        });
        frame.pack();
        frame.setLocationByPlatform(true);
        frame.setVisible(true);
    }

    /** The icon of the window, a ball as on the status page. */
    private static BufferedImage icon() {
        int side = 32;
        BufferedImage icon = new BufferedImage(side, side, BufferedImage.TYPE_INT_ARGB);
        var g = icon.createGraphics();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setPaint(new RadialGradientPaint(0.35F * side, 0.3F * side, 0.6F * side, new float[] {0, 1}, new Color[] {
            new Color(0xfff6d8), new Color(0xc2571a)
        }));
        g.fillOval(1, 1, side - 2, side - 2);
        g.dispose();
        return icon;
    }

    /** The title of the window: progress, title of the render, and remaining time. */
    static String title(Status status) {
        State state = status.state();
        String how = state == State.RENDERING ? status.percent() + " %" : state.word();
        String left = state == State.RENDERING && status.remainingSeconds().isPresent()
                ? " – " + (long) Math.ceil(status.remainingSeconds().getAsDouble()) + " s left"
                : "";
        return how + " – " + status.title() + left;
    }

    private void look() {
        try {
            while (!closed.await(PERIOD_MILLIS, TimeUnit.MILLISECONDS)) {
                try {
                    lookOnce();
                } catch (OutOfMemoryError e) {
                    // The remaining memory is for the render: the next attempt is after a pause.
                    nextNanos = System.nanoTime() + SHORTAGE_NANOS;
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void lookOnce() {
        Status status = source.status();
        boolean isOver = status.state().isOver();
        boolean isDue = status.picture() != shown && System.nanoTime() - nextNanos >= 0 || isOver && !isLast;
        Optional<Image> image = isDue ? source.image() : Optional.empty();
        long start = System.nanoTime();
        int[] argb = image.map(Image::toArgb).orElse(null);
        if (isDue) {
            // The shortest time of all: longer ones include waiting for a processor.
            tookNanos = Math.min(tookNanos, System.nanoTime() - start);
            nextNanos = start + (long) (tookNanos / SHARE);
        }
        shown = isDue ? status.picture() : shown;
        isLast = isOver;
        String title = title(status);
        SwingUtilities.invokeLater(() -> {
            if (!title.equals(frame.getTitle())) {
                frame.setTitle(title);
            }
            if (argb != null) {
                canvas.show(image.get().width(), image.get().height(), argb);
            }
        });
    }

    /** Waits until the window is closed, or another reason to end is true, which is polled. */
    public void awaitClosed(BooleanSupplier reason) {
        try {
            while (!reason.getAsBoolean() && !closed.await(PATIENCE_MILLIS, TimeUnit.MILLISECONDS)) {
                // The condition polls the reason again.
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Closes the window; has no effect if it is closed already. */
    @Override
    public void close() {
        closed.countDown();
        SwingUtilities.invokeLater(frame::dispose);
    }
}
