package starlogo.models.collada
{
    import starlogo.models.building.FileAnimation;
    import starlogo.models.building.FilePose;
    import starlogo.models.building.ModelBuilder;
    import starlogo.steps.finish;

    /**
     * An animation of a COLLADA document. At each time its channels give numbers to elements. The key of an element's numbers is
     * <code>ColladaElement.key</code>.
     *
     * @private
     */
    public final class ColladaAnimation implements FileAnimation
    {
        private var _document:ColladaDocument;
        private var _upAxis:Object;
        private var _name:String;
        private var _start:Number;
        private var _end:Number;
        private var _channels:Object = {}; // lists of those that move an element, by the element's key

        /**
         * @param document the document
         * @param upAxis as for ColladaReader
         * @param name its name
         * @param channels what moves
         * @param start the time in the document when it starts, in seconds
         * @param end the time when it ends; NaN for the last key
         */
        public function ColladaAnimation(document:ColladaDocument, upAxis:Object, name:String, channels:Vector.<ColladaChannel>, start:Number, end:Number)
        {
            _document = document;
            _upAxis = upAxis;
            _name = name;
            _start = start;
            var lastKey:Number = start;
            for each (var channel:ColladaChannel in channels)
            {
                if (channel.element != null)
                {
                    (_channels[channel.element.key] ||= new Vector.<ColladaChannel>()).push(channel);
                    lastKey = Math.max(lastKey, channel.sampler.end);
                }
            }
            _end = end == end ? end : lastKey;
        }

        /**
         * Reads the animations of a document. If there are any, it makes a pose, so that the geometries and skins are read and checked.
         *
         * @param name the model's name
         * @param text the document's text
         * @param upAxis as for ColladaReader
         * @throws ModelError if the document is wrong
         */
        public static function allIn(name:String, text:String, upAxis:Object):Vector.<FileAnimation>
        {
            var document:ColladaDocument = new ColladaDocument(name, text);
            finish(document.xml);
            document.limits.restart();
            var root:ColladaElement = document.root;
            var read:Object = {};
            var animations:Vector.<FileAnimation> = new Vector.<FileAnimation>();
            var all:Vector.<ColladaElement> = entriesOf(root, "library_animations", "animation");
            var clips:Vector.<ColladaElement> = entriesOf(root, "library_animation_clips", "animation_clip");
            for each (var clip:ColladaElement in clips)
            {
                var parts:Vector.<ColladaElement> = new Vector.<ColladaElement>();
                for each (var part:ColladaElement in clip.childrenNamed("instance_animation"))
                {
                    parts.push(part.target("url", ["animation"]));
                }
                var start:Number = clip.toNumber(clip.attribute("start") || "0");
                var end:Number = clip.attribute("end") == "" ? NaN : clip.toNumber(clip.attribute("end"));
                clip.refuseIf(end < start, "it ends before it starts");
                animations.push(new ColladaAnimation(document, upAxis, clip.attribute("name") || clip.id, channelsOf(parts, read), start, end));
            }
            if (clips.length == 0 && all.length > 0)
            {
                animations.push(new ColladaAnimation(document, upAxis, "", channelsOf(all, read), 0, NaN));
            }
            if (animations.length > 0)
            {
                animations[0].verticesAt(0);
            }
            return animations;
        }

        // The children with a name of all libraries with a name.
        private static function entriesOf(root:ColladaElement, libraryName:String, name:String):Vector.<ColladaElement>
        {
            var entries:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var library:ColladaElement in root.childrenNamed(libraryName))
            {
                entries = entries.concat(library.childrenNamed(name));
            }
            return entries;
        }

        // The channels of some animations, and of those within them. A channel is read once, even if several clips have it.
        // @param read the channels that are read so far, by the index of their elements
        private static function channelsOf(elements:Vector.<ColladaElement>, read:Object):Vector.<ColladaChannel>
        {
            var channels:Vector.<ColladaChannel> = new Vector.<ColladaChannel>();
            var pending:Vector.<ColladaElement> = elements.slice().reverse();
            while (pending.length > 0)
            {
                var element:ColladaElement = pending.pop();
                element.limits.countElements(1 + element.children.length, element);
                for each (var channel:ColladaElement in element.childrenNamed("channel"))
                {
                    channels.push(read[channel.index] ||= new ColladaChannel(channel));
                }
                for each (var inner:ColladaElement in element.childrenNamed("animation").reverse())
                {
                    pending.push(inner);
                }
            }
            return channels;
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
            _document.limits.restart();
            return ModelBuilder.verticesOf(new ColladaReader(_document, _upAxis, null, new FilePose(this, Math.min(_start + Math.max(time, 0), _end))));
        }

        /** @inheritDoc */
        public function numbersAt(key:String, time:Number):Vector.<Number>
        {
            var channels:Vector.<ColladaChannel> = _channels[key];
            if (channels == null)
            {
                return null;
            }
            var numbers:Vector.<Number> = channels[0].numbersAtRest();
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
