package starlogo.models.collada
{
    import starlogo.models.FileAnimation;

    /** An animation of a COLLADA document. At each time it gives numbers to elements, in place of those that the document has for them. */
    internal final class ColladaAnimation implements FileAnimation
    {
        private var _figure:ColladaFigure;
        private var _name:String;
        private var _start:Number;
        private var _end:Number;
        private var _channels:Object = {}; // lists of those that move an element, by the element's index

        /**
         * @param figure the document
         * @param name its name
         * @param channels what moves
         * @param start the time in the document when it starts, in seconds
         * @param end the time when it ends; NaN for the last key
         */
        public function ColladaAnimation(figure:ColladaFigure, name:String, channels:Vector.<ColladaChannel>, start:Number = 0, end:Number = NaN)
        {
            _figure = figure;
            _name = name;
            _start = start;
            var lastKey:Number = start;
            for each (var channel:ColladaChannel in channels)
            {
                if (channel.element != null)
                {
                    (_channels[channel.element.index] ||= new Vector.<ColladaChannel>()).push(channel);
                    lastKey = Math.max(lastKey, channel.sampler.end);
                }
            }
            _end = end == end ? end : lastKey;
        }

        /** The animation of a clip. */
        internal static function ofClip(figure:ColladaFigure, clip:ColladaElement, channels:Vector.<ColladaChannel>):ColladaAnimation
        {
            var start:Number = clip.toNumber(clip.attribute("start") || "0");
            var end:Number = clip.attribute("end") == "" ? NaN : clip.toNumber(clip.attribute("end"));
            clip.refuseIf(end < start, "it ends before it starts");
            return new ColladaAnimation(figure, clip.attribute("name") || clip.id, channels, start, end);
        }

        /** @inheritDoc */
        public function get name():String
        {
            return _name;
        }

        /** @inheritDoc */
        public function get duration():Number
        {
            return _end - _start;
        }

        /** @inheritDoc */
        public function verticesAt(time:Number):Vector.<Number>
        {
            return _figure.verticesAt(this, Math.min(_start + Math.max(time, 0), _end));
        }

        /** The numbers of an element at a time of the document; null if they stay. */
        internal function numbersOf(element:ColladaElement, time:Number):Vector.<Number>
        {
            var channels:Vector.<ColladaChannel> = _channels[element.index];
            if (channels == null)
            {
                return null;
            }
            var numbers:Vector.<Number> = element.numbers(channels[0].size);
            for each (var channel:ColladaChannel in channels)
            {
                var values:Vector.<Number> = channel.sampler.valueAt(time);
                for (var i:int = 0; i < values.length; i++)
                {
                    numbers[channel.first + i] = values[i];
                }
            }
            return numbers;
        }
    }
}
