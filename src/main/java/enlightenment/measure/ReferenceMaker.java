package enlightenment.measure;

import enlightenment.file.WholeFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.image.PngOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;

/**
 * Makes what is taken for the truth: the mean of one long render by each method, with seeds that no run uses. Each part is
 * kept in a file, so that nobody has to wait for it twice.
 */
final class ReferenceMaker {
    /** How much of the budget the parts may take together, without sweeps and with. */
    private static final double SHARE = 0.4;

    private static final double SHARE_WITH_SWEEPS = 0.3;

    private static final double LEAST_SAMPLES = 16;
    private static final int PILOTS = 3;
    private static final double MOST_SAMPLES = 1 << 16;

    /** For the two renders that tell the error of a given reference. */
    private static final double PROBE_SHARE = 0.1;

    /**
     * Light points for each hit of a part made of evenly spaced rays, if the scene does not ask for fewer: few for each of many
     * rays lead to the same picture in less time. Fitted: 2 took 0.6 to 0.8 of the time to equal error that 10 and 25 took.
     */
    private static final int LIGHT_POINTS = 2;

    private final Session session;

    ReferenceMaker(Session session) {
        this.session = session;
    }

    Reference make() throws IOException {
        Reference reference = session.settings.reference().isPresent()
                ? given(session.settings.reference().get())
                : made();
        ImageFiles.writePfm(reference.image(), session.folder.file("reference.pfm"));
        // Finer than eight bits: errors of a thousandth are to be told from those of the file.
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
            part(i, contender(methods.get(i)), share, images, parts);
        }
        return Reference.meanOf(images, parts);
    }

    /** Every method once, or the only one twice: of a single render nobody could tell how good it is. */
    private List<String> pair() {
        List<String> methods = session.settings.methods();
        return methods.size() > 1 ? methods : List.of(methods.get(0), methods.get(0));
    }

    private Contender contender(String method) {
        Contender own = session.settings.own(method);
        boolean fewer = !Contender.variants(own).isEmpty() && LIGHT_POINTS < own.lightPoints();
        return fewer ? new Contender(method, LIGHT_POINTS, false) : own;
    }

    private long seed(int part) {
        return session.settings.base().seed() - 1 - part;
    }

    /** One part from its file, or rendered. */
    private void part(int index, Contender contender, double share, List<Image> images, List<Reference.Part> parts)
            throws IOException {
        Path note = session.folder.file("reference-" + (index + 1) + ".txt");
        Path file = session.folder.file("reference-" + (index + 1) + ".pfm");
        if (Files.exists(note) && Files.exists(file)) {
            images.add(ImageFiles.read(file));
            parts.add(part(contender, samples(note), index));
            return;
        }
        double samples = samples(contender, share * session.settings.budgetSeconds());
        session.say("reference: " + contender.name() + ", " + (long) samples + " samples per pixel");
        Image image = session.timed(contender, samples, seed(index)).image();
        ImageFiles.writePfm(image, file);
        // Last, as it says that the picture is whole.
        WholeFile.write(note, samples + "\n");
        images.add(image);
        parts.add(part(contender, samples, index));
    }

    private Reference.Part part(Contender contender, double samples, int index) {
        return new Reference.Part(contender.method(), contender.lightPoints(), samples, seed(index));
    }

    private static double samples(Path note) throws IOException {
        try {
            return Double.parseDouble(Files.readString(note).strip());
        } catch (NumberFormatException e) {
            throw new IOException(note + ": is not what the command trade wrote", e);
        }
    }

    /** The largest power of two that fits into so many seconds: that many samples are the best distributed. */
    private double samples(Contender contender, double seconds) {
        long seed = session.settings.base().seed();
        for (int k = 0; k < PILOTS && session.expected(contender, LEAST_SAMPLES) < seconds / 4; k++) {
            // The rate of few samples has the start in it, and the first render of more is not yet compiled.
            session.timed(contender, LEAST_SAMPLES, seed);
        }
        double samples = LEAST_SAMPLES;
        while (2 * samples <= MOST_SAMPLES && session.expected(contender, 2 * samples) <= seconds) {
            samples *= 2;
        }
        return samples;
    }

    private Reference given(Image image) {
        session.say("looking at the reference");
        List<String> methods = pair();
        List<Image> images = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            Contender contender = contender(methods.get(i));
            double samples = samples(contender, PROBE_SHARE / 2 * session.settings.budgetSeconds());
            images.add(session.timed(contender, samples, seed(i)).image());
        }
        return Reference.given(image, images.get(0), images.get(1));
    }
}
