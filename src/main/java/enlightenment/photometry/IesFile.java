package enlightenment.photometry;

import enlightenment.file.FileFailure;
import enlightenment.file.InputFile;
import java.io.IOException;
import java.nio.file.Path;

/**
 * Reads files of luminous intensities, IESNA LM-63 of 1986, 1991, 1995, 2002 and 2019, with photometry of type C. Intensities are multiplied by
 * the file's multiplier and ballast factor, and in files before 1995 by the ballast-lamp photometric factor. The factors for tilted lamps are passed over.
 */
public final class IesFile {
    /** The longest file, in bytes; published ones have less than a megabyte. */
    public static final int MOST_BYTES = 1 << 24;

    /** The most intensities. */
    static final int MOST_VALUES = 1 << 18;

    /** The most vertical angles, and the most half planes: those of steps of a hundredth and of a tenth of a degree. */
    private static final int MOST_ROWS = 18_001;

    private static final int MOST_COLUMNS = 3601;

    /** The most pairs of angle and factor for tilted lamps. */
    private static final int MOST_TILTS = 1 << 16;

    private static final int TYPE_C = 1;
    private static final int TYPE_A = 3;

    private final IesText text;

    /** Whether the number behind the ballast factor is a factor, too. */
    private boolean isBefore1995 = true;

    private IesFile(byte[] content) {
        text = new IesText(content);
    }

    /**
     * Reads a file.
     *
     * @throws IOException if it cannot be read; the message names the file, and the line where its content is wrong
     */
    public static IntensityTable read(Path file) throws IOException {
        try {
            return of(InputFile.start(file, MOST_BYTES + 1));
        } catch (IOException e) {
            throw FileFailure.named(file, e);
        }
    }

    /**
     * Reads the bytes of a file.
     *
     * @throws IOException if they are no such file; the message names the line
     */
    public static IntensityTable of(byte[] content) throws IOException {
        if (content.length > MOST_BYTES) {
            throw new IOException("has more than " + MOST_BYTES + " bytes, which no IES file has");
        }
        return new IesFile(content).table();
    }

    private IntensityTable table() throws IOException {
        header();
        text.number("the number of lamps");
        text.number("the lumens of a lamp");
        double factor = text.notNegative("the multiplier of candelas");
        int rows = text.count("the number of vertical angles", 2, MOST_ROWS);
        int columns = text.count("the number of horizontal angles", 1, Math.min(MOST_COLUMNS, MOST_VALUES / rows));
        int type = text.count("the photometric type", TYPE_C, TYPE_A);
        if (type != TYPE_C) {
            throw text.failure("has photometry of type " + (type == TYPE_A ? "A" : "B") + "; only type C can be read");
        }
        text.count("the type of units", 1, 2);
        text.number("the width");
        text.number("the length");
        text.number("the height");
        factor *= text.notNegative("the ballast factor");
        double last = text.notNegative("the number behind the ballast factor");
        factor *= isBefore1995 ? last : 1;
        text.number("the watts");
        double[] vertical = angles(rows, "a vertical angle", 180);
        double[] horizontal = angles(columns, "a horizontal angle", 360);
        IesPlanes planes = IesPlanes.of(horizontal, text);
        double[][] candela = new double[columns][rows];
        for (double[] plane : candela) {
            for (int row = 0; row < rows; row++) {
                plane[row] = factor * text.notNegative("an intensity");
                if (!(plane[row] < Double.POSITIVE_INFINITY)) {
                    throw text.failure("has an intensity beyond the range of doubles");
                }
            }
        }
        return new IntensityTable(vertical, planes.angles(), planes.all(candela));
    }

    /** Passes over all up to the numbers: the name of the standard, keywords, and the factors for tilted lamps. */
    private void header() throws IOException {
        String line = text.line();
        if (line.startsWith("IES")) {
            isBefore1995 = line.startsWith("IESNA91") || line.contains("LM-63-1986") || line.contains("LM-63-1991");
            line = text.line();
        }
        while (!line.startsWith("TILT=")) {
            if (text.atEnd()) {
                throw text.failure("has no line that begins with \"TILT=\", which every IES file has");
            }
            line = text.line();
        }
        if (line.equals("TILT=INCLUDE")) {
            text.number("the geometry of the lamp");
            int pairs = text.count("the number of tilt angles", 0, MOST_TILTS);
            for (int i = 0; i < 2 * pairs; i++) {
                text.number("a tilt angle or factor");
            }
        }
    }

    private double[] angles(int count, String what, double most) throws IOException {
        double[] angles = new double[count];
        for (int i = 0; i < count; i++) {
            angles[i] = text.notNegative(what);
            if (angles[i] > most || i > 0 && !(angles[i] > angles[i - 1])) {
                throw text.failure("has " + what + " of " + angles[i] + "; angles ascend and are at most " + most);
            }
        }
        return angles;
    }
}
