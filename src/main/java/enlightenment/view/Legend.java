package enlightenment.view;

import enlightenment.image.Image;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntFunction;

/**
 * The legend of a false-colour picture: names by colour, those of most pixels first.
 *
 * @param entries the entries, at most {@link #MOST}
 * @param more number of colours without an entry
 */
record Legend(List<Entry> entries, int more) {
    /** The most entries. */
    static final int MOST = 40;

    static final Legend NONE = new Legend(List.of(), 0);

    /**
     * A colour of the picture.
     *
     * @param name the object or material
     * @param color the colour as {@code #rrggbb}
     * @param share its share of the pixels, 0..1
     */
    record Entry(String name, String color, double share) {}

    private record Found(int number, int firstPixel, int pixels) {}

    /**
     * The legend of a picture.
     *
     * @param numbers number of the object or material at each pixel, −1 for none; all components are equal
     * @param picture the colours, of the same size
     * @param name name of an object or material by its number
     */
    static Legend of(Image numbers, Image picture, IntFunction<String> name) {
        int width = numbers.width();
        int all = width * numbers.height();
        Map<Integer, Found> found = new HashMap<>();
        for (int i = 0; i < all; i++) {
            int number = (int) numbers.component(i % width, i / width, 0);
            if (number >= 0) {
                Found one = found.get(number);
                found.put(
                        number,
                        one == null ? new Found(number, i, 1) : new Found(number, one.firstPixel, one.pixels + 1));
            }
        }
        List<Found> sorted = new ArrayList<>(found.values());
        sorted.sort(Comparator.comparingInt((Found f) -> -f.pixels).thenComparingInt(f -> f.number));
        List<Entry> entries = new ArrayList<>();
        for (Found f : sorted.subList(0, Math.min(MOST, sorted.size()))) {
            String color = color(picture, f.firstPixel % width, f.firstPixel / width);
            entries.add(new Entry(name.apply(f.number), color, (double) f.pixels / all));
        }
        return new Legend(List.copyOf(entries), sorted.size() - entries.size());
    }

    private static String color(Image picture, int x, int y) {
        int rgb = 0;
        for (int c = 0; c < 3; c++) {
            rgb = rgb << 8 | (int) (255 * picture.displayed(x, y, c) + 0.5);
        }
        return String.format("#%06x", rgb);
    }
}
