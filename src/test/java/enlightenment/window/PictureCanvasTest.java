package enlightenment.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.status.State;
import enlightenment.status.Status;
import java.awt.Dimension;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class PictureCanvasTest {
    private static final Rectangle SCREEN = new Rectangle(0, 0, 1000, 800);
    private static final int AROUND = 0xff202020;

    private static BufferedImage painted(PictureCanvas canvas, int width, int height) {
        canvas.setSize(width, height);
        BufferedImage screen = new BufferedImage(width, height, BufferedImage.TYPE_INT_ARGB);
        canvas.paintComponent(screen.createGraphics());
        return screen;
    }

    @Test
    void pixelsOfASmallPictureAreSquares() {
        PictureCanvas canvas = new PictureCanvas(3, 2, SCREEN);
        int[] argb = {0xffff0000, 0xff00ff00, 0xff0000ff, 0xffffffff, 0xff000000, 0xff123456};
        canvas.show(3, 2, argb);
        // Four times as large, with a column on both sides, a row above and two below.
        BufferedImage screen = painted(canvas, 3 * 4 + 2, 2 * 4 + 3);
        for (int y = 0; y < screen.getHeight(); y++) {
            for (int x = 0; x < screen.getWidth(); x++) {
                int column = Math.floorDiv(x - 1, 4);
                int row = Math.floorDiv(y - 1, 4);
                boolean isOutside = column < 0 || column > 2 || row < 0 || row > 1;
                assertEquals(isOutside ? AROUND : argb[3 * row + column], screen.getRGB(x, y), x + ", " + y);
            }
        }
    }

    @Test
    void aLargePictureIsMadeSmallerAndItsColoursAreMeans() {
        PictureCanvas canvas = new PictureCanvas(400, 200, SCREEN);
        int[] argb = new int[400 * 200];
        java.util.Arrays.fill(argb, 0xff808080);
        canvas.show(400, 200, argb);
        BufferedImage screen = painted(canvas, 100, 100);
        assertEquals(AROUND, screen.getRGB(50, 24));
        assertEquals(0xff808080, screen.getRGB(50, 50));
        assertEquals(AROUND, screen.getRGB(50, 75));
    }

    @Test
    void aWindowTakesAsMuchOfTheScreenAsIsGood() {
        assertEquals(new Dimension(600, 300), new PictureCanvas(200, 100, SCREEN).getPreferredSize());
        assertEquals(new Dimension(800, 400), new PictureCanvas(800, 400, SCREEN).getPreferredSize());
        assertEquals(new Dimension(32, 32), new PictureCanvas(1, 1, SCREEN).getPreferredSize());
        Dimension large = new PictureCanvas(8000, 4000, SCREEN).getPreferredSize();
        assertTrue(large.width <= 1000 && large.width > 800 && large.width == 2 * large.height, large.toString());
    }

    @Test
    void zoomGoesByWholeNumbersAboveOneAndByHalvesBelow() {
        PictureCanvas canvas = new PictureCanvas(200, 100, SCREEN);
        int[] widths = {800, 1000};
        for (int width : widths) {
            canvas.setSize(canvas.getPreferredSize());
            canvas.zoom(true);
            assertEquals(width, canvas.getPreferredSize().width);
        }
        for (int width : new int[] {800, 600, 400, 200, 100, 50}) {
            canvas.setSize(canvas.getPreferredSize());
            canvas.zoom(false);
            assertEquals(width, canvas.getPreferredSize().width);
        }
        for (int width : new int[] {100, 200, 400}) {
            canvas.setSize(canvas.getPreferredSize());
            canvas.zoom(true);
            assertEquals(width, canvas.getPreferredSize().width);
        }
    }

    @Test
    void aFrameOfAnotherSizeIsShownToo() {
        PictureCanvas canvas = new PictureCanvas(3, 2, SCREEN);
        canvas.show(1, 1, new int[] {0xff00ff00});
        assertEquals(0xff00ff00, painted(canvas, 5, 5).getRGB(2, 2));
    }

    private static String title(State state, OptionalDouble left) {
        return PictureWindow.title(new Status("a scene", state, 42, 100, "pixels", 3, left, 1, Map.of(), List.of()));
    }

    @Test
    void theTitleTellsHowFarItIs() {
        assertEquals("42 % \u2013 a scene \u2013 8 s left", title(State.RENDERING, OptionalDouble.of(7.2)));
        assertEquals("42 % \u2013 a scene", title(State.RENDERING, OptionalDouble.empty()));
        assertEquals("preparing \u2013 a scene", title(State.PREPARING, OptionalDouble.empty()));
        assertEquals("finished \u2013 a scene", title(State.FINISHED, OptionalDouble.of(0)));
        assertEquals("stopped \u2013 a scene", title(State.STOPPED, OptionalDouble.of(0)));
    }
}
