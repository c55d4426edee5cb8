package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
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
 * Makes the reference: the mean of two long renders by the best configurations of a trial. No run uses their seeds. Each part is kept in a
 * file, so that a resumed measurement need not render it again.
 */
final class ReferenceMaker {
    /** The share of the budget for all parts together, without sweeps and with. */
    private static final double SHARE = 0.4;

    private static final double SHARE_WITH_SWEEPS = 0.3;

    /** Number of renders averaged by the reference: the error of a single one would be unknown. */
    static final int PARTS = 2;

    /** Share of the trials in the time for the parts. */
    private static final double TRIALS = 0.25;

    private static final double MIN_SAMPLES = 16;
    private static final double MAX_SAMPLES = 1 << 16;

    /** The share for the two renders that estimate the error of a given reference. */
    private static final double PROBE_SHARE = 0.1;

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
        ImageFiles.writePng(
                reference.image(), session.folder.file("reference.png"), new ImageFiles.PngOptions(16, Map.of()));
        return reference;
    }

    private Reference made() throws IOException {
        double share = session.settings.sweeps().isEmpty() ? SHARE : SHARE_WITH_SWEEPS;
        double seconds = share * session.settings.budgetSeconds();
        List<Image> images = new ArrayList<>();
        List<Reference.Part> parts = new ArrayList<>();
        List<Configuration> chosen = List.of();
        for (int i = 0; i < PARTS; i++) {
            if (!isKept(i) && chosen.isEmpty()) {
                chosen = new ReferenceTrial(session).run(TRIALS * seconds);
            }
            parts.add(isKept(i) ? kept(i, images) : part(i, chosen.get(i), seconds / PARTS, images));
        }
        return meanOf(images, parts);
    }

    private long seed(int part) {
        return session.settings.base().seed() - 1 - part;
    }

    private Path note(int part) {
        return session.folder.file("reference-" + (part + 1) + ".txt");
    }

    private Path picture(int part) {
        return session.folder.file("reference-" + (part + 1) + ".pfm");
    }

    private boolean isKept(int part) {
        return Files.exists(note(part)) && Files.exists(picture(part));
    }

    /** Reads a part from its file. */
    private Reference.Part kept(int index, List<Image> images) throws IOException {
        Reference.Part part = MeasurementFile.part(note(index));
        images.add(session.read(picture(index)));
        return part;
    }

    private Reference.Part part(int index, Configuration configuration, double seconds, List<Image> images)
            throws IOException {
        double samples = samples(configuration, seconds);
        session.say("reference: " + configuration.name() + ", " + (long) samples + " samples per pixel");
        Image image = session.timed(configuration, samples, seed(index)).image();
        ImageFiles.writePfm(image, picture(index));
        Reference.Part part =
                new Reference.Part(configuration.method(), configuration.lightSamples(), samples, seed(index));
        // Written last, as it marks the part as complete.
        WholeFile.write(note(index), MeasurementFile.text(part) + "\n");
        images.add(image);
        return part;
    }

    /** The largest power of two samples per pixel that fits into a time in seconds: such samples are best distributed. */
    private double samples(Configuration configuration, double seconds) {
        double samples = MIN_SAMPLES;
        while (2 * samples <= MAX_SAMPLES && session.expected(configuration, 2 * samples) <= seconds) {
            samples *= 2;
        }
        return samples;
    }

    private Reference given(Image image) {
        session.say("estimating the error of the reference");
        double seconds = PROBE_SHARE * session.settings.budgetSeconds();
        List<Configuration> chosen = new ReferenceTrial(session).run(TRIALS * seconds);
        List<Image> images = new ArrayList<>();
        for (int i = 0; i < PARTS; i++) {
            Configuration configuration = chosen.get(i);
            double samples = samples(configuration, seconds / PARTS);
            images.add(session.timed(configuration, samples, seed(i)).image());
        }
        return given(image, images.get(0), images.get(1));
    }

    /**
     * The mean of independent renders. The mean squared difference of two of them estimates the sum of their variances, so the
     * differences of all pairs estimate the variance of the mean without any assumption about the methods: for n renders, their
     * sum over all pairs divided by n²(n − 1). The mean is in linear light if the renders are; differences are in display units.
     *
     * @param images the renders, at least two, of one size
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
     * A reference given by the user. The differences of two independent renders from it have only its own error in common, bias included: their
     * mean product is an estimate of its mean squared error. The result is at least the standard error of that mean, with pixels assumed
     * independent.
     */
    static Reference given(Image reference, Image a, Image b) {
        double sum = 0;
        double squares = 0;
        for (int y = 0; y < reference.height(); y++) {
            for (int x = 0; x < reference.width(); x++) {
                for (int c = 0; c < 3; c++) {
                    double r = reference.displayed(x, y, c);
                    double product = (a.displayed(x, y, c) - r) * (b.displayed(x, y, c) - r);
                    sum += product;
                    squares += product * product;
                }
            }
        }
        double n = 3.0 * reference.width() * reference.height();
        double mean = sum / n;
        double chance = Math.sqrt(Math.max(squares / n - mean * mean, 0) / n);
        return new Reference(Optional.of(reference), Math.max(mean, chance), List.of());
    }
}
