package program;

import enlightenment.image.Image;
import java.awt.image.BufferedImage;

/** What a program that has to do with AWT needs: the renderer's core knows nothing of it. */
final class Pictures {
    private Pictures() {}

    static BufferedImage buffered(Image image) {
        int width = image.width();
        BufferedImage picture = new BufferedImage(width, image.height(), BufferedImage.TYPE_INT_RGB);
        picture.setRGB(0, 0, width, image.height(), image.toArgb(), 0, width);
        return picture;
    }
}
