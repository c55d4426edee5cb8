package enlightenment.method;

import java.util.ArrayList;
import java.util.List;

/** Selects fields of a grid that are evenly spread over it. */
public final class SpreadPlaces {
    private SpreadPlaces() {}

    /**
     * {@code count} different fields, or all of them if there are no more: those with the lowest thresholds of {@link Dither}, row by row.
     */
    public static List<int[]> of(int columns, int rows, int count) {
        List<int[]> places = of(columns, rows, 0, (double) count / ((double) columns * rows));
        if (places.isEmpty()) {
            places.add(new int[] {columns / 2, rows / 2});
        }
        return places;
    }

    /**
     * About this share of the fields, row by row: those whose thresholds of {@link Dither} lie in a range, which continues at 0 where it
     * passes 1. Two adjacent ranges have no field in common, and their union is as even as each.
     *
     * @param from where the range begins, 0..1
     * @param share its length, 0..1; from 1 on all fields are in it
     */
    public static List<int[]> of(int columns, int rows, double from, double share) {
        List<int[]> places = new ArrayList<>();
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                double t = Dither.at(x, y) - from;
                if ((t < 0 ? t + 1 : t) < share) {
                    places.add(new int[] {x, y});
                }
            }
        }
        return places;
    }
}
