package enlightenment.codec;

import java.awt.image.BufferedImage;
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

/** Writes an animated GIF file through the JDK: each frame with 256 colours of its own. Plays for ever. */
public final class GifWriter implements AutoCloseable {
    private static final String FORMAT = "javax_imageio_gif_image_1.0";

    private final ImageWriter writer;
    private final ImageOutputStream stream;
    private boolean begun;

    /**
     * @param out receives the file; stays open
     * @throws IOException if this Java writes no GIF files
     */
    public GifWriter(OutputStream out) throws IOException {
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("gif");
        if (!writers.hasNext()) {
            throw new IOException("this Java cannot write GIF files");
        }
        writer = writers.next();
        // In memory: ImageIO's own choice would be a file in the folder for temporary files.
        stream = new MemoryCacheImageOutputStream(out);
        writer.setOutput(stream);
        writer.prepareWriteSequence(null);
    }

    /**
     * Adds a frame.
     *
     * @param picture components of 8 or 16 bits
     * @param hundredths how long it is shown, in hundredths of a second, 0..65535
     */
    public void add(Raster picture, int hundredths) throws IOException {
        BufferedImage image = new BufferedImage(picture.width(), picture.height(), BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, picture.width(), picture.height(), packed(picture), 0, picture.width());
        ImageWriteParam param = writer.getDefaultWriteParam();
        IIOMetadata metadata = writer.getDefaultImageMetadata(new ImageTypeSpecifier(image), param);
        IIOMetadataNode root = new IIOMetadataNode(FORMAT);
        root.appendChild(control(hundredths));
        if (!begun) {
            root.appendChild(forEver());
            begun = true;
        }
        metadata.mergeTree(FORMAT, root);
        writer.writeToSequence(new IIOImage(image, null, metadata), param);
        stream.flushBefore(stream.getStreamPosition());
    }

    private static int[] packed(Raster picture) throws IOException {
        if (picture.packed() != null) {
            return picture.packed();
        }
        char[] deep = picture.deep();
        if (deep == null) {
            throw new IOException("a file of floats cannot be a frame");
        }
        int[] packed = new int[picture.width() * picture.height()];
        for (int i = 0; i < packed.length; i++) {
            packed[i] = eightBits(deep[3 * i]) << 16 | eightBits(deep[3 * i + 1]) << 8 | eightBits(deep[3 * i + 2]);
        }
        return packed;
    }

    /** 65535 is 257 times 255. */
    private static int eightBits(char sixteen) {
        return (sixteen + 128) / 257;
    }

    private static IIOMetadataNode control(int hundredths) {
        IIOMetadataNode control = new IIOMetadataNode("GraphicControlExtension");
        control.setAttribute("disposalMethod", "none");
        control.setAttribute("userInputFlag", "FALSE");
        control.setAttribute("transparentColorFlag", "FALSE");
        control.setAttribute("delayTime", Integer.toString(hundredths));
        control.setAttribute("transparentColorIndex", "0");
        return control;
    }

    /** What Netscape's browser asked for first. */
    private static IIOMetadataNode forEver() {
        IIOMetadataNode loop = new IIOMetadataNode("ApplicationExtension");
        loop.setAttribute("applicationID", "NETSCAPE");
        loop.setAttribute("authenticationCode", "2.0");
        loop.setUserObject(new byte[] {1, 0, 0});
        IIOMetadataNode extensions = new IIOMetadataNode("ApplicationExtensions");
        extensions.appendChild(loop);
        return extensions;
    }

    /** Completes the file. */
    public void finish() throws IOException {
        writer.endWriteSequence();
        stream.flush();
    }

    /** Ends the writing, complete or not. */
    @Override
    public void close() {
        writer.dispose();
    }
}
