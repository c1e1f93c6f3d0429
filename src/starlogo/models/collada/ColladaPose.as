package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.shortened;

    /** A COLLADA document at a time of an animation: the numbers that its elements have then, and where its nodes are. */
    internal final class ColladaPose
    {
        /** The document. Its poses share its geometries and skins. */
        public var figure:ColladaFigure;

        private var _animation:ColladaAnimation;
        private var _time:Number;
        private var _places:Object = {}; // of nodes in the scene, by their indices

        // of the elements that were asked for, by their indices: the scene may place an element often
        private var _numbers:Object = {};
        private var _transforms:Object = {};

        /**
         * @param figure the document
         * @param animation moves it
         * @param time of the document, in seconds
         */
        public function ColladaPose(figure:ColladaFigure, animation:ColladaAnimation, time:Number)
        {
            this.figure = figure;
            _animation = animation;
            _time = time;
        }

        /** The numbers that the animation gives to an element; null if they stay. */
        public function numbersOf(element:ColladaElement):Vector.<Number>
        {
            if (!(element.index in _numbers))
            {
                _numbers[element.index] = _animation.numbersOf(element, _time);
            }
            return _numbers[element.index];
        }

        /** The transform that an element is; null if it is none. */
        public function transformOf(element:ColladaElement):AffineTransform
        {
            var numbers:Vector.<Number> = numbersOf(element);
            return numbers == null ? element.toTransform() : (_transforms[element.index] ||= ColladaTransform.of(element, numbers));
        }

        /** Takes where a node is in the scene. If it is there several times, the first place counts, for all skins. */
        public function place(node:ColladaElement, transform:AffineTransform):void
        {
            _places[node.index] ||= transform;
        }

        /** Where a node is. @param user what needs it, for the error @throws ModelError if it is not in the scene */
        public function placeOf(node:ColladaElement, user:ColladaElement):AffineTransform
        {
            var found:AffineTransform = _places[node.index];
            user.refuseIf(found == null, "its joint \"" + shortened(node.attribute("sid") || node.id) + "\" is not in the scene");
            return found;
        }
    }
}
