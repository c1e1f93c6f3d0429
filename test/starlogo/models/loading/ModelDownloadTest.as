package starlogo.models.loading
{
    import org.flexunit.asserts.assertEquals;
    import support.OfferingURLLoader;

    public class ModelDownloadTest
    {
        [Test]
        public function aProblemHasTheAddress():void
        {
            assertEquals("its file can't be fetched: models/bear.obj (404)", problemWith("404"));
            assertEquals("its file can't be fetched: models/bear.obj", problemWith("Error #2032: Stream Error"));
            assertEquals("its file can't be fetched: http://a/models/bear.obj", problemWith("Error #2032: Stream Error. URL: http://a/models/bear.obj"));
        }

        private static function problemWith(text:String):String
        {
            return new ModelDownload("models/bear.obj", new OfferingURLLoader({}, text)).problem;
        }
    }
}
