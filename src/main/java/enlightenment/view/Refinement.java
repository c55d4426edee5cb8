package enlightenment.view;

import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.view.frame.FrameBuilder;
import enlightenment.view.frame.PassPlan;
import java.util.List;
import java.util.function.LongSupplier;

/** Renders the picture of a view pass by pass, until the view changes or has enough samples. Runs on a thread of its own. */
final class Refinement implements Runnable {
    private static final double NANO = 1e-9;

    private final ViewSession session;
    private final ScenePreparation preparation;
    private final SceneSource source;
    private final int threads;
    private final int samples;
    private final LongSupplier clock;

    /** Seconds per sample of a pixel in the last pass; infinite before the first. */
    private double secondsPerPixel = Double.POSITIVE_INFINITY;

    /**
     * @param preparation prepares the scene
     * @param source finds the lines of problems
     * @param threads number of threads of a pass
     * @param samples samples per pixel of a finished picture
     * @param clock nanoseconds of any origin
     */
    Refinement(
            ViewSession session,
            ScenePreparation preparation,
            SceneSource source,
            int threads,
            int samples,
            LongSupplier clock) {
        this.session = session;
        this.preparation = preparation;
        this.source = source;
        this.threads = threads;
        this.samples = samples;
        this.clock = clock;
    }

    @Override
    public void run() {
        long done = 0;
        try {
            while (!session.isClosed()) {
                Shot shot = session.awaitShot(done);
                if (shot != null) {
                    refineSafely(shot);
                    done = shot.generation();
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void refineSafely(Shot shot) throws InterruptedException {
        List<String> problems = RefinementProblems.of(() -> refine(shot), source);
        if (!problems.isEmpty()) {
            session.failed(shot.generation(), problems);
        }
    }

    private void refine(Shot shot) throws InterruptedException {
        FrameBuilder builder = new FrameBuilder(shot.generation());
        PassPlan pass = PassPlan.first(secondsPerPixel, shot.size().pixels());
        long change = clock.getAsLong();
        while (pass != null && session.isCurrent(shot.generation())) {
            session.awaitProcessors(shot.generation());
            RenderRequest request = preparation
                    .request(shot, shot.settings(pass, threads), () -> !session.isCurrent(shot.generation()))
                    .withAuxiliary(RenderResult.Auxiliary.SAMPLES);
            long start = clock.getAsLong();
            RenderResult result = shot.film().render(request);
            if (!result.complete()) {
                return;
            }
            long end = clock.getAsLong();
            double seconds = (end - start) * NANO;
            long pixels = (long) result.image().width() * result.image().height();
            secondsPerPixel = seconds / (pixels * pass.samples());
            PassPlan next = pass.next(seconds, samples);
            session.publish(builder.add(pass, result, next == null, (end - change) * NANO, session.exposure()));
            pass = next;
        }
    }
}
