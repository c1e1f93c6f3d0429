package starlogo.models.loading
{
    import flash.events.ProgressEvent;
    import flash.net.URLLoader;
    import org.flexunit.asserts.assertEquals;
    import support.OfferingURLLoader;

    public class FileDownloadTest
    {
        [Test]
        public function aProblemHasTheAddress():void
        {
            assertEquals("its file can't be fetched: models/bear.obj (404)", problemWith("404"));
            assertEquals("its file can't be fetched: models/bear.obj", problemWith("Error #2032: Stream Error"));
            assertEquals("its file can't be fetched: http://a/models/bear.obj", problemWith("Error #2032: Stream Error. URL: http://a/models/bear.obj"));
        }

        [Test]
        public function theProgressIsAtMostAll():void
        {
            var loader:URLLoader = new WaitingURLLoader();
            var download:FileDownload = new FileDownload("models/bear.obj", loader);
            loader.dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, 20, 80));
            assertEquals(0.25, download.progress);
            // a server that compresses the file tells the compressed size
            loader.dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, 200, 80));
            assertEquals(1, download.progress);
            loader.dispatchEvent(new ProgressEvent(ProgressEvent.PROGRESS, false, false, 200, 0));
            assertEquals(0, download.progress);
        }

        private static function problemWith(text:String):String
        {
            return new FileDownload("models/bear.obj", new OfferingURLLoader({}, text)).problem;
        }
    }
}

import flash.net.URLLoader;
import flash.net.URLRequest;

class WaitingURLLoader extends URLLoader
{
    override public function load(request:URLRequest):void
    {
    }
}
