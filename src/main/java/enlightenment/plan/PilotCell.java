package enlightenment.plan;

import enlightenment.scene.RenderSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/**
 * A square of neighbouring pixels, by their indices where the pixels of some rectangles lie row by row and one rectangle after another.
 *
 * @param even pixels of one chessboard colour
 * @param odd those of the other; empty for a single pixel
 */
record PilotCell(int[] even, int[] odd) {
    /** Of a cell that no rectangle cuts, in pixels. */
    static final int SIDE = 4;

    /** All cells of these rectangles, each of which is divided from its first pixel on. */
    static List<PilotCell> of(List<RenderSettings.Crop> rectangles) {
        List<PilotCell> cells = new ArrayList<>();
        int first = 0;
        for (RenderSettings.Crop rectangle : rectangles) {
            for (int top = 0; top < rectangle.height(); top += SIDE) {
                for (int left = 0; left < rectangle.width(); left += SIDE) {
                    cells.add(of(rectangle, first, left, top));
                }
            }
            first += rectangle.width() * rectangle.height();
        }
        return cells;
    }

    private static PilotCell of(RenderSettings.Crop rectangle, int first, int left, int top) {
        List<IntStream.Builder> colors = List.of(IntStream.builder(), IntStream.builder());
        for (int y = top; y < Math.min(top + SIDE, rectangle.height()); y++) {
            for (int x = left; x < Math.min(left + SIDE, rectangle.width()); x++) {
                colors.get((x ^ y) & 1).add(first + rectangle.width() * y + x);
            }
        }
        return new PilotCell(
                colors.get(0).build().toArray(), colors.get(1).build().toArray());
    }

    /** Of all its pixels in an array that has three bands of each. */
    int[] entries(int band) {
        return IntStream.concat(IntStream.of(even), IntStream.of(odd))
                .map(pixel -> 3 * pixel + band)
                .toArray();
    }
}
