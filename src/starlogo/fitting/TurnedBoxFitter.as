package starlogo.fitting
{
    /** Base class of fitters that rotate a box by multiples of an increment, and keep the smallest (thesis §3.4.2). */
    public class TurnedBoxFitter extends Fitter
    {
        private var _name:String;
        private var _isAboutAll:Boolean;
        private var _degIncrement:Number;

        /**
         * For subclasses only.
         *
         * @param name of the algorithm, for its signature
         * @param isAboutAll whether boxes are rotated about x and y too, or about z only
         * @param degIncrement the increment in degrees, above 0
         * @throws ArgumentError if it is not a positive, finite number
         */
        public function TurnedBoxFitter(name:String, isAboutAll:Boolean, degIncrement:Number)
        {
            _name = name;
            _isAboutAll = isAboutAll;
            this.degIncrement = degIncrement;
        }

        /**
         * The increment in degrees, above 0.
         *
         * @throws ArgumentError if it is set to a value that is not a positive, finite number
         */
        public function get degIncrement():Number
        {
            return _degIncrement;
        }

        public function set degIncrement(value:Number):void
        {
            if (!(value > 0 && value < Infinity))
            {
                throw new ArgumentError("the increment must be a positive number of degrees: " + value);
            }
            _degIncrement = value;
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return _name + " " + _degIncrement;
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            var search:RotationSearch = new RotationSearch(session, _isAboutAll ? _degIncrement : 90, _degIncrement);
            return new Fit(session, search.smallestBox, search);
        }
    }
}
