package enlightenment.codec;

import java.awt.Point;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.awt.image.DirectColorModel;
import java.awt.image.SinglePixelPackedSampleModel;
import java.awt.image.WritableRaster;
import java.io.IOException;
import java.io.OutputStream;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageOutputStream;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes JPEG files through the JDK: baseline JFIF, 8 bits per component, without comments and colour profile, so that readers take it
 * for sRGB. The bytes depend on the picture and on the JDK's encoder, on nothing else.
 */
public final class JpegWriter {
    /** What the JDK calls the quality, of 0..1; libjpeg's 95 of 100. */
    public static final double QUALITY = 0.95;

    /** Columns or rows of the largest picture: the limit of libjpeg, which the JDK has in it; files could have 65535. */
    public static final int LARGEST_SIDE = 65_500;

    private static final int[] MASKS = {0xff0000, 0xff00, 0xff};

    private JpegWriter() {}

    /**
     * Writes a picture to a stream, which stays open.
     *
     * @param width in pixels, at most {@link #LARGEST_SIDE}
     * @param height in pixels, at most {@link #LARGEST_SIDE}
     * @param rgb width·height numbers 0xRRGGBB, row by row from the top; higher bits are ignored
     * @throws IOException also if this Java cannot write JPEG files
     */
    public static void write(int width, int height, int[] rgb, OutputStream out) throws IOException {
        if (width > LARGEST_SIDE || height > LARGEST_SIDE) {
            throw new IllegalArgumentException(
                    "a JPEG file has at most " + LARGEST_SIDE + " columns and rows, not " + width + " x " + height);
        }
        ImageWriter writer = ownWriter();
        // In memory: ImageIO's own choice would be a file in the folder for temporary files.
        try (ImageOutputStream stream = new MemoryCacheImageOutputStream(out)) {
            ImageWriteParam settings = writer.getDefaultWriteParam();
            settings.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            settings.setCompressionQuality((float) QUALITY);
            BufferedImage image = image(width, height, rgb);
            IIOMetadata metadata =
                    writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(image), settings);
            keepColorResolution(metadata);
            writer.setOutput(stream);
            writer.write(null, new IIOImage(image, null, metadata), settings);
        } finally {
            writer.dispose();
        }
    }

    /** The JDK's: a library on the class path may bring another one, which would write other bytes. */
    private static ImageWriter ownWriter() throws IOException {
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("jpeg");
        while (writers.hasNext()) {
            ImageWriter writer = writers.next();
            if ("java.desktop".equals(writer.getClass().getModule().getName())) {
                return writer;
            }
            writer.dispose();
        }
        throw new IOException("this Java cannot write JPEG files");
    }

    /** Not {@code BufferedImage}'s own array: that would be a second copy of the picture. */
    private static BufferedImage image(int width, int height, int[] rgb) {
        WritableRaster raster = java.awt.image.Raster.createWritableRaster(
                new SinglePixelPackedSampleModel(DataBufferInt.TYPE_INT, width, height, MASKS),
                new DataBufferInt(rgb, rgb.length),
                new Point());
        return new BufferedImage(new DirectColorModel(24, MASKS[0], MASKS[1], MASKS[2]), raster, false, null);
    }

    /** The default halves the resolution of colours, which smears edges between saturated ones. */
    private static void keepColorResolution(IIOMetadata metadata) throws IOException {
        String format = metadata.getNativeMetadataFormatName();
        IIOMetadataNode tree = (IIOMetadataNode) metadata.getAsTree(format);
        sampleAllColors(tree);
        metadata.setFromTree(format, tree);
    }

    private static void sampleAllColors(IIOMetadataNode node) {
        if (node.getNodeName().equals("componentSpec")) {
            node.setAttribute("HsamplingFactor", "1");
            node.setAttribute("VsamplingFactor", "1");
        }
        IIOMetadataNode child = (IIOMetadataNode) node.getFirstChild();
        while (child != null) {
            sampleAllColors(child);
            child = (IIOMetadataNode) child.getNextSibling();
        }
    }
}
