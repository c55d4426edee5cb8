package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class FilmTileTest {
    @Test
    void aBrightSampleDoesNotSwallowManyDimOnes() {
        FilmTile tile = new FilmTile(3, 4, 1, 1);
        tile.add(3, 4, 1e12, 0, 0);
        int n = 1_000_000;
        for (int i = 0; i < n; i++) {
            tile.add(3, 4, 1e-5, 0, 0);
        }
        double exact = (1e12 + n * 1e-5) / (n + 1.0);
        assertEquals(exact, tile.mean(3, 4, 0), Math.ulp(exact));
        assertEquals(n + 1, tile.count(3, 4));
    }

    @Test
    void aPixelWithoutSamplesIsBlack() {
        assertEquals(0, new FilmTile(0, 0, 2, 2).mean(1, 1, 2));
    }
}
