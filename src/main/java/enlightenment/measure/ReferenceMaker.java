package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import enlightenment.measure.analysis.Configuration;
import enlightenment.measure.trade.Reference;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Makes the reference: the mean of one long render by each method, with seeds that no run uses. Each part is kept in a file, so that
 * a resumed measurement has it at once.
 */
final class ReferenceMaker {
    /** The share of the budget for all parts together, without sweeps and with. */
    private static final double SHARE = 0.4;

    private static final double SHARE_WITH_SWEEPS = 0.3;

    private static final double MIN_SAMPLES = 16;
    private static final int PILOTS = 3;
    private static final double MAX_SAMPLES = 1 << 16;

    /** The share for the two renders that estimate the error of a given reference. */
    private static final double PROBE_SHARE = 0.1;

    /**
     * Light samples per hit of a part by {@code raytrace}, unless the scene asks for fewer: many camera rays with few light samples
     * each converge sooner. Fitted: 2 took 0.6 to 0.8 of the time to equal error of 10 and 25.
     */
    private static final int LIGHT_SAMPLES = 2;

    private final Session session;

    ReferenceMaker(Session session) {
        this.session = session;
    }

    Reference make() throws IOException {
        Reference reference = session.settings.reference().isPresent()
                ? given(session.settings.reference().get())
                : made();
        ImageFiles.writePfm(reference.image(), session.folder.file("reference.pfm"));
        // Sixteen bits: rounding to eight would add an error of a thousandth.
        ImageFiles.writePng(reference.image(), session.folder.file("reference.png"), new PngOptions(16, Map.of()));
        return reference;
    }

    private Reference made() throws IOException {
        boolean sweeps = !session.settings.sweeps().isEmpty();
        List<String> methods = pair();
        double share = (sweeps ? SHARE_WITH_SWEEPS : SHARE) / methods.size();
        List<Image> images = new ArrayList<>();
        List<Reference.Part> parts = new ArrayList<>();
        for (int i = 0; i < methods.size(); i++) {
            part(i, configuration(methods.get(i)), share, images, parts);
        }
        return meanOf(images, parts);
    }

    /** Every method once, or the only one twice: the error of a single render is unknown. */
    private List<String> pair() {
        List<String> methods = session.settings.methods();
        return methods.size() > 1 ? methods : List.of(methods.get(0), methods.get(0));
    }

    private Configuration configuration(String method) {
        Configuration own = Configuration.ofScene(session.settings, method);
        boolean fewer = !Configuration.variants(own).isEmpty() && LIGHT_SAMPLES < own.lightSamples();
        return fewer ? new Configuration(method, LIGHT_SAMPLES, false) : own;
    }

    private long seed(int part) {
        return session.settings.base().seed() - 1 - part;
    }

    /** One part from its file, or rendered. */
    private void part(
            int index, Configuration configuration, double share, List<Image> images, List<Reference.Part> parts)
            throws IOException {
        Path note = session.folder.file("reference-" + (index + 1) + ".txt");
        Path file = session.folder.file("reference-" + (index + 1) + ".pfm");
        if (Files.exists(note) && Files.exists(file)) {
            images.add(session.read(file));
            parts.add(part(configuration, samples(note), index));
            return;
        }
        double samples = samples(configuration, share * session.settings.budgetSeconds());
        session.say("reference: " + configuration.name() + ", " + (long) samples + " samples per pixel");
        Image image = session.timed(configuration, samples, seed(index)).image();
        ImageFiles.writePfm(image, file);
        // Last: it marks the part as whole.
        WholeFile.write(note, samples + "\n");
        images.add(image);
        parts.add(part(configuration, samples, index));
    }

    private Reference.Part part(Configuration configuration, double samples, int index) {
        return new Reference.Part(configuration.method(), configuration.lightSamples(), samples, seed(index));
    }

    private static double samples(Path note) throws IOException {
        try {
            return Double.parseDouble(Files.readString(note).strip());
        } catch (NumberFormatException e) {
            throw new IOException(note + ": is not what the command trade wrote", e);
        }
    }

    /** The largest power of two that fits into this many seconds: powers of two are the best distributed. */
    private double samples(Configuration configuration, double seconds) {
        long seed = session.settings.base().seed();
        for (int k = 0; k < PILOTS && session.expected(configuration, MIN_SAMPLES) < seconds / 4; k++) {
            // A small budget includes fixed costs, and Java may still be compiling.
            session.timed(configuration, MIN_SAMPLES, seed);
        }
        double samples = MIN_SAMPLES;
        while (2 * samples <= MAX_SAMPLES && session.expected(configuration, 2 * samples) <= seconds) {
            samples *= 2;
        }
        return samples;
    }

    private Reference given(Image image) {
        session.say("estimating the error of the reference");
        List<String> methods = pair();
        List<Image> images = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Configuration configuration = configuration(methods.get(i));
            double samples = samples(configuration, PROBE_SHARE / 2 * session.settings.budgetSeconds());
            images.add(session.timed(configuration, samples, seed(i)).image());
        }
        return given(image, images.get(0), images.get(1));
    }

    /**
     * The mean of independent renders. The mean squared difference of two of them estimates the sum of their variances, so the
     * differences of all pairs estimate the variance of the mean without any assumption about the methods: for n renders, their
     * sum over all pairs divided by n²(n − 1). The mean is one of light where the renders are, the differences are those of what a screen
     * shows.
     *
     * @param images at least two, of one size
     */
    static Reference meanOf(List<Image> images, List<Reference.Part> parts) {
        int n = images.size();
        int width = images.get(0).width();
        int height = images.get(0).height();
        float[] mean = new float[3 * width * height];
        double squares = 0;
        int i = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                for (int c = 0; c < 3; c++) {
                    double sum = 0;
                    for (int a = 0; a < n; a++) {
                        sum += images.get(a).component(x, y, c);
                        double value = images.get(a).displayed(x, y, c);
                        for (int b = 0; b < a; b++) {
                            double d = value - images.get(b).displayed(x, y, c);
                            squares += d * d;
                        }
                    }
                    mean[i++] = (float) (sum / n);
                }
            }
        }
        double variance = squares / mean.length / ((double) n * n * (n - 1));
        return new Reference(
                Optional.of(new Image(width, height, mean, images.get(0).curve())), variance, parts);
    }

    /**
     * An image that the user gave. The differences of two independent renders from it have only its own error in common, bias
     * included: their mean product estimates its mean squared error.
     */
    static Reference given(Image reference, Image a, Image b) {
        double sum = 0;
        for (int y = 0; y < reference.height(); y++) {
            for (int x = 0; x < reference.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    double r = reference.displayed(x, y, c);
                    sum += (a.displayed(x, y, c) - r) * (b.displayed(x, y, c) - r);
                }
            }
        }
        double mean = sum / (3.0 * reference.width() * reference.height());
        return new Reference(Optional.of(reference), Math.max(mean, 0), List.of());
    }
}
