package enlightenment.codec;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.util.Iterator;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.MemoryCacheImageInputStream;

/**
 * Reads JPEG and BMP files through the JDK; needs no display. Colour spaces and transparency are not applied: the numbers
 * are taken as they are. Two JDKs may decode the same JPEG file to numbers that differ by one.
 */
final class ImageIoReader {
    /** ImageIO's name of JPEG files. */
    static final String JPEG = "jpeg";

    private ImageIoReader() {}

    /**
     * Decodes a whole file.
     *
     * @param format the name by which ImageIO knows this kind of file: jpeg or bmp
     */
    static Raster read(byte[] file, String format) throws IOException {
        Iterator<ImageReader> readers = ImageIO.getImageReadersByFormatName(format);
        if (!readers.hasNext()) {
            throw new IOException("this Java cannot read " + format + " files");
        }
        if (format.equals(JPEG)) {
            JpegEnd.require(file);
        }
        ImageReader reader = readers.next();
        // In memory: ImageIO's own choice would be a file in the folder for temporary files.
        try (ImageInputStream input = new MemoryCacheImageInputStream(new ByteArrayInputStream(file))) {
            reader.setInput(input, true, true);
            return read(reader);
        } catch (EOFException e) {
            throw new IOException("it ends too early", e);
        } catch (RuntimeException e) { // ImageIO's readers meet damage with all kinds of them
            throw new IOException("it is damaged", e);
        } finally {
            reader.dispose();
        }
    }

    private static Raster read(ImageReader reader) throws IOException {
        Raster.checkSize(reader.getWidth(0), reader.getHeight(0));
        String[] complaint = new String[1];
        reader.addIIOReadWarningListener((source, warning) -> {
            if (warning.contains("remature end")) { // libjpeg's words; it would fill up with grey
                complaint[0] = warning;
            }
        });
        BufferedImage image = readPixels(reader);
        if (complaint[0] != null) {
            throw new IOException("it is damaged: " + complaint[0]);
        }
        Raster raster = Raster.ofBytes(image.getWidth(), image.getHeight());
        if (image.getColorModel() instanceof ComponentColorModel) {
            copySamples(image, raster);
        } else {
            image.getRGB(0, 0, raster.width(), raster.height(), raster.packed(), 0, raster.width());
            for (int i = 0; i < raster.packed().length; i++) {
                raster.packed()[i] &= 0xffffff;
            }
        }
        return raster;
    }

    private static BufferedImage readPixels(ImageReader reader) throws IOException {
        try {
            return reader.read(0);
        } catch (OutOfMemoryError e) { // the picture does not fit; nothing else is lost
            throw new IOException("there is not enough memory for its pixels", e);
        }
    }

    /** Without AWT's colour conversion, which takes grey for linear light. */
    private static void copySamples(BufferedImage image, Raster raster) {
        java.awt.image.Raster source = image.getRaster();
        int bands = source.getNumBands();
        int green = bands < 3 ? 0 : 1;
        int blue = bands < 3 ? 0 : 2;
        int[] row = new int[bands * raster.width()];
        int pixel = 0;
        for (int y = 0; y < raster.height(); y++) {
            source.getPixels(0, y, raster.width(), 1, row);
            for (int i = 0; i < row.length; i += bands) {
                raster.packed()[pixel++] = row[i] << 16 | row[i + green] << 8 | row[i + blue];
            }
        }
    }
}
