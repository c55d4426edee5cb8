package enlightenment.importer.gltf;

import enlightenment.file.InputFile;
import enlightenment.image.Image;
import enlightenment.image.ImageFormat;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.InputFolder;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;

/** The images of a glTF file as files: those beside it where they lie, those inside it extracted, and others that are made of them. */
final class ImageStore {
    /** What is made of an image. */
    interface Making {
        /** @throws IOException with the reason, if the image cannot be read */
        Image make(Path file) throws IOException;
    }

    private final GltfElement document;
    private final GltfBuffers buffers;
    private final InputFolder folder;
    private final ExtractedFiles extracted;
    private final Map<Integer, Path> files = new HashMap<>();
    private final Map<String, Path> made = new HashMap<>();

    ImageStore(GltfElement document, GltfBuffers buffers, InputFolder folder, ExtractedFiles extracted) {
        this.document = document;
        this.buffers = buffers;
        this.folder = folder;
        this.extracted = extracted;
    }

    /**
     * The file of an image.
     *
     * @throws IOException naming the image, if there is none that can be a texture
     */
    Path file(int index) throws IOException {
        Path known = files.get(index);
        if (known == null) {
            known = find(document.item("images", index));
            files.put(index, known);
        }
        return known;
    }

    private Path find(GltfElement image) throws IOException {
        String uri = image.text("uri", "");
        if (!uri.isEmpty() && !GltfBuffers.isData(uri)) {
            try {
                Path file = folder.file(GltfBuffers.decoded(uri));
                format(image, InputFile.start(file, ImageFormat.SIGNATURE_LENGTH));
                return file;
            } catch (IOException e) {
                throw image.failure(e.getMessage());
            }
        }
        byte[] bytes = uri.isEmpty() ? inView(image) : buffers.resource(image);
        ImageFormat format = format(image, bytes);
        return extracted.write(format.word(), out -> out.write(bytes));
    }

    private byte[] inView(GltfElement image) throws IOException {
        int view = image.index("bufferView", document.size("bufferViews"))
                .orElseThrow(() -> image.failure("has neither a \"uri\" nor a \"bufferView\""));
        ByteBuffer in = buffers.view(view);
        byte[] bytes = new byte[in.limit()];
        in.get(bytes);
        return bytes;
    }

    /** By its content: what files and media types say is often wrong. */
    private static ImageFormat format(GltfElement image, byte[] content) throws IOException {
        byte[] start = Arrays.copyOf(content, Math.min(content.length, ImageFormat.SIGNATURE_LENGTH));
        return ImageFormat.ofContent(start)
                .filter(ImageFormat.textures()::contains)
                .orElseThrow(() -> image.failure("is neither PNG nor JPEG"
                        + (has(content, "WEBP", 8) ? ", but WebP" : has(content, "KTX ", 1) ? ", but KTX" : "")));
    }

    private static boolean has(byte[] content, String text, int from) {
        for (int i = 0; i < text.length(); i++) {
            if (from + i >= content.length || content[from + i] != text.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    /**
     * A PNG file of 16 bits that is made of an image, once.
     *
     * @param what what is made: for each the same
     * @throws IOException naming the image, if it cannot be read
     */
    Path made(int index, String what, Making making) throws IOException {
        String key = index + " " + what;
        Path known = made.get(key);
        if (known == null) {
            Path source = file(index);
            Image image;
            try {
                image = making.make(source);
            } catch (IOException e) {
                throw document.item("images", index).failure(Plain.lines(e.getMessage()));
            }
            known = extracted.picture(image);
            made.put(key, known);
        }
        return known;
    }
}
