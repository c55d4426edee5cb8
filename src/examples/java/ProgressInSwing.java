import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.awt.BorderLayout;
import java.awt.GraphicsEnvironment;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.Supplier;
import javax.swing.DefaultBoundedRangeModel;
import javax.swing.ImageIcon;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JProgressBar;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;

/**
 * A render inside a Swing program: a bar, the picture as it grows, and a button that stops it.
 *
 * <pre>
 * java -cp enlightenment-0.1.0.jar:jackson-core.jar src/examples/java/ProgressInSwing.java scenes/fire-and-ice.json
 * </pre>
 *
 * <p>Without a display only the model runs, and prints how it ended.
 */
public final class ProgressInSwing {
    private ProgressInSwing() {}

    /** What the window shows, and nothing of the window: it can be tested without a display. */
    static final class Model implements RenderProgress {
        /** Percent. Changed on Swing's thread alone, as Swing's models ask. */
        final DefaultBoundedRangeModel percent = new DefaultBoundedRangeModel(0, 0, 0, 100);

        private static final long PERIOD_NANOS = 250_000_000L;
        private final Consumer<BufferedImage> view;
        private long next = System.nanoTime();

        /** @param view is given pictures on Swing's thread */
        Model(Consumer<BufferedImage> view) {
            this.view = view;
        }

        /** Begins a render; cancelling the future stops it. */
        CompletableFuture<RenderResult> start(Scene scene, ExecutorService executor) {
            // Watched: the first picture is whole, if coarse.
            RenderRequest request = RenderRequest.of(scene).withWatched(true).withProgress(this);
            CompletableFuture<RenderResult> result = Renderer.submit(request, executor);
            result.thenAccept(r -> show(r.image()));
            return result;
        }

        @Override
        public void coarse(Supplier<Image> soFar) {
            show(soFar.get());
        }

        /** Called by the threads that render, one at a time, which wait for it: a few pictures a second are enough. */
        @Override
        public void progress(long done, long total, Supplier<Image> soFar) {
            SwingUtilities.invokeLater(() -> percent.setValue((int) (100 * done / total)));
            if (System.nanoTime() - next >= 0) {
                show(soFar.get());
                next = System.nanoTime() + PERIOD_NANOS;
            }
        }

        private void show(Image image) {
            BufferedImage picture = image.toBufferedImage();
            SwingUtilities.invokeLater(() -> view.accept(picture));
        }
    }

    public static void main(String[] args) throws Exception {
        Scene scene = SceneReader.read(Path.of(args[0]));
        ExecutorService executor = Executors.newSingleThreadExecutor();
        try {
            if (GraphicsEnvironment.isHeadless()) {
                Model model = new Model(picture -> {});
                boolean isComplete = model.start(scene, executor).get().complete();
                // What was posted to Swing's thread is done before this is.
                SwingUtilities.invokeAndWait(
                        () -> System.out.println(model.percent.getValue() + " %, complete: " + isComplete));
            } else {
                SwingUtilities.invokeAndWait(() -> open(scene, executor));
            }
        } finally {
            // Takes no more work, and lets the render end.
            executor.shutdown();
        }
    }

    private static void open(Scene scene, ExecutorService executor) {
        JLabel picture = new JLabel(new ImageIcon(new BufferedImage(scene.width(), scene.height(), 1)));
        Model model = new Model(image -> picture.setIcon(new ImageIcon(image)));
        CompletableFuture<RenderResult> result = model.start(scene, executor);
        JButton stop = new JButton("Stop");
        stop.addActionListener(e -> result.cancel(true));
        JFrame frame = new JFrame(scene.name());
        frame.setDefaultCloseOperation(WindowConstants.EXIT_ON_CLOSE);
        frame.add(picture, BorderLayout.CENTER);
        frame.add(new JProgressBar(model.percent), BorderLayout.NORTH);
        frame.add(stop, BorderLayout.SOUTH);
        frame.pack();
        frame.setVisible(true);
    }
}
