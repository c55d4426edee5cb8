package enlightenment.cli;

import enlightenment.cli.terminal.ShutdownSignal;
import enlightenment.cli.terminal.Terminal;
import java.awt.Component;
import java.awt.EventQueue;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.awt.image.BufferedImage;
import java.io.File;
import java.nio.file.Path;
import java.util.concurrent.FutureTask;
import javax.imageio.ImageIO;
import javax.swing.JFrame;

/**
 * A process that runs a command with a window, looks at the screen, and closes the window: {@code WindowProbe finished|growing PICTURE
 * COMMAND...}. Says what it saw, and ends with the command's exit code.
 */
final class WindowProbe {
    private WindowProbe() {}

    public static void main(String[] args) throws Exception {
        String[] command = java.util.Arrays.copyOfRange(args, 2, args.length);
        FutureTask<Integer> code =
                new FutureTask<>(() -> Main.run(command, new Terminal(System.out, System.out, new ShutdownSignal())));
        Thread running = new Thread(code);
        running.setDaemon(true);
        running.start();
        JFrame frame = frame();
        if (args[0].equals("finished")) {
            untilTitled(frame, "finished");
            untilTheScreenShows(frame, ImageIO.read(new File(args[1])));
        } else {
            // Not only coarse passes, of which a stopped render keeps nothing.
            untilTitled(frame, " s left");
            untilSomethingIsLit(frame);
        }
        ImageIO.write(
                new Robot().createScreenCapture(frame.getBounds()),
                "png",
                Path.of(args[1] + ".window.png").toFile());
        EventQueue.invokeAndWait(() -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING)));
        System.out.println("ended with " + code.get());
        // As Main does; the threads of a window must not keep it.
        System.exit(code.get());
    }

    private static JFrame frame() throws InterruptedException {
        while (true) {
            for (Window window : Window.getWindows()) {
                if (window instanceof JFrame frame && frame.isShowing()) {
                    return frame;
                }
            }
            Thread.sleep(20);
        }
    }

    private static void untilTitled(JFrame frame, String part) throws InterruptedException {
        while (!frame.getTitle().contains(part)) {
            Thread.sleep(20);
        }
        System.out.println("title " + frame.getTitle());
    }

    private static BufferedImage screen(JFrame frame) throws Exception {
        Component canvas = frame.getContentPane().getComponent(0);
        Point corner = canvas.getLocationOnScreen();
        return new Robot().createScreenCapture(new Rectangle(corner, canvas.getSize()));
    }

    private static void untilTheScreenShows(JFrame frame, BufferedImage picture) throws Exception {
        while (true) {
            BufferedImage screen = screen(frame);
            int times = screen.getWidth() / picture.getWidth();
            if (isShown(screen, picture, times)) {
                System.out.println("shown " + times + " times as large");
                return;
            }
            Thread.sleep(50);
        }
    }

    private static boolean isShown(BufferedImage screen, BufferedImage picture, int times) {
        boolean isSame = times > 0 && screen.getHeight() == times * picture.getHeight();
        for (int y = 0; isSame && y < screen.getHeight(); y++) {
            for (int x = 0; isSame && x < screen.getWidth(); x++) {
                isSame = (screen.getRGB(x, y) ^ picture.getRGB(x / times, y / times)) << 8 == 0;
            }
        }
        return isSame;
    }

    private static void untilSomethingIsLit(JFrame frame) throws Exception {
        while (true) {
            BufferedImage screen = screen(frame);
            for (int i = 0; i < screen.getWidth() * screen.getHeight(); i++) {
                if ((screen.getRGB(i % screen.getWidth(), i / screen.getWidth()) & 0xff) > 0x80) {
                    System.out.println("something is lit");
                    return;
                }
            }
            Thread.sleep(50);
        }
    }
}
