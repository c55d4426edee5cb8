package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import enlightenment.image.Image;
import enlightenment.picture.ReducedPicture;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FilmInFileTest {
    @TempDir
    private Path folder;

    /** A film whose pixels are their column and row, but for the last row, which is missing. */
    private FilmInFile film(int x, int y, int width, int height) {
        FilmInFile film = new FilmInFile(x, y, width, height, DisplayCurve.NONE, folder);
        film.put(x, y, width, height - 1, (column, row, pixel) -> {
            pixel.means[0] = column;
            pixel.means[1] = row;
            pixel.samples = 1;
        });
        return film;
    }

    @Test
    void whoLooksAtASmallPictureSeesAllOfIt() {
        FilmInFile film = film(13, 6, 50, 30);
        assertArrayEquals(film.toImage().toArray(), film.shown().toArray());
    }

    @Test
    void whoLooksAtALargePictureSeesEveryThirdColumnAndRow() {
        FilmInFile film = film(13, 6, 1301, 1000);
        Image shown = film.shown();
        assertEquals(434, shown.width());
        assertEquals(334, shown.height());
        for (int row = 0; row < 333; row++) {
            for (int column = 0; column < 434; column++) {
                assertEquals(13 + 3 * column, shown.component(column, row, 0));
                assertEquals(6 + 3 * row, shown.component(column, row, 1));
            }
        }
        assertEquals(0, shown.component(1, 333, 0), "missing");
        Image reduced = ReducedPicture.of(film.toImage(), ReducedPicture.MOST_PIXELS);
        assertEquals(434, reduced.width());
        assertArrayEquals(shown.toArray(), reduced.toArray());
        assertTrue(434 * 334 <= 1 << 18 && 651 * 500 > 1 << 18);
    }
}
