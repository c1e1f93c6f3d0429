package starlogo.models
{
    import flash.net.URLLoader;
    import support.OfferingURLLoader;

    /** A ModelLoader that has files at hand. */
    internal class OfferingLoader extends ModelLoader
    {
        private var _files:Object;

        /** @param files the files, by address */
        public function OfferingLoader(receiver:ModelReceiver, budget:Number, files:Object)
        {
            super(receiver, budget);
            _files = files;
        }

        override internal function newURLLoader():URLLoader
        {
            return new OfferingURLLoader(_files);
        }
    }
}
