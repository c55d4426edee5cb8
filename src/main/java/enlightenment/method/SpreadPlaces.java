package enlightenment.method;

import java.util.ArrayList;
import java.util.List;

/** Some fields of a grid, evenly spread over it. */
public final class SpreadPlaces {
    private SpreadPlaces() {}

    /**
     * So many different fields, or all of them if there are not more: those with the lowest thresholds of {@link Dither}, row by
     * row.
     */
    public static List<int[]> of(int columns, int rows, int count) {
        double share = (double) count / ((double) columns * rows);
        List<int[]> places = new ArrayList<>();
        for (int y = 0; y < rows; y++) {
            for (int x = 0; x < columns; x++) {
                if (Dither.at(x, y) < share) {
                    places.add(new int[] {x, y});
                }
            }
        }
        if (places.isEmpty()) {
            places.add(new int[] {columns / 2, rows / 2});
        }
        return places;
    }
}
