package enlightenment.photometry;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The half planes all around that those of a file stand for, mirrored as the range of their angles says. */
final class IesPlanes {
    private final List<Double> angles = new ArrayList<>();

    /** For each of them the place of its intensities in the file. */
    private final List<Integer> sources = new ArrayList<>();

    private IesPlanes() {}

    /**
     * The half planes by their angles in a file: 0 alone, alike in all directions; 0 to 90, mirrored at two planes; 0 to 180, mirrored at
     * one; 0 to 360, all of them; 90 to 270, mirrored at the plane of these two.
     *
     * @param given ascending degrees
     * @throws IOException if they cover none of these ranges
     */
    static IesPlanes of(double[] given, IesText text) throws IOException {
        IesPlanes planes = new IesPlanes();
        double first = given[0];
        double end = given[given.length - 1];
        if (given.length == 1) {
            planes.add(0, 0);
            planes.add(360, 0);
        } else if (first == 90 && end == 270 && Arrays.binarySearch(given, 180) >= 0) {
            planes.turn(given);
        } else if (first == 0 && (end == 90 || end == 180 || end == 360)) {
            for (int i = 0; i < given.length; i++) {
                planes.add(given[i], i);
            }
            for (double mirror = end; mirror < 360; mirror *= 2) {
                planes.mirror(mirror);
            }
        } else {
            throw text.failure("has horizontal angles from " + first + " to " + end
                    + "; they are one alone, or go from 0 to 90, 180 or 360, or from 90 by 180 to 270");
        }
        return planes;
    }

    private void add(double angle, int source) {
        angles.add(angle);
        sources.add(source);
    }

    private void mirror(double at) {
        for (int i = angles.size() - 2; i >= 0; i--) {
            add(2 * at - angles.get(i), sources.get(i));
        }
    }

    /** From 90 to 270 degrees: what lies from 0 to 90 and from 270 to 360 mirrors what lies from 180 to 90 and from 270 to 180. */
    private void turn(double[] given) {
        for (int i = given.length - 1; i >= 0; i--) {
            if (given[i] <= 180 && given[i] > 90) {
                add(180 - given[i], i);
            }
        }
        for (int i = 0; i < given.length; i++) {
            add(given[i], i);
        }
        for (int i = given.length - 2; i >= 0; i--) {
            if (given[i] >= 180) {
                add(540 - given[i], i);
            }
        }
    }

    /** Degrees, ascending from 0 to 360. */
    double[] angles() {
        return angles.stream().mapToDouble(a -> a).toArray();
    }

    /** The intensities all around. */
    double[][] all(double[][] given) {
        return sources.stream().map(i -> given[i]).toArray(double[][]::new);
    }
}
