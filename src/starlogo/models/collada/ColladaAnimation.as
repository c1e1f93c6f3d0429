package starlogo.models.collada
{
    import starlogo.models.animation.FileAnimation;
    import starlogo.models.animation.FilePose;
    import starlogo.models.building.ModelBuilder;
    import starlogo.steps.finish;

    /**
     * An animation of a COLLADA document. At each time its channels give numbers to elements. The target is an element:
     * <code>ColladaElement.index</code>.
     *
     * @private
     */
    public final class ColladaAnimation implements FileAnimation
    {
        private var _document:ColladaDocument;
        private var _upAxis:Object;
        private var _name:String;

        // When it starts and ends, in the document's time, in seconds. Without an end of its own it ends at the last key.
        private var _start:Number;
        private var _end:Number;
        private var _channels:Object = {}; // lists of those that move an element, by the element's index

        /**
         * @param document the document
         * @param upAxis as for ColladaReader
         * @param channels what moves
         * @param clip the clip's element, which says the name, the start and the end; null for all of the document's time, without a name
         * @throws ModelError if the clip's times are wrong
         */
        public function ColladaAnimation(document:ColladaDocument, upAxis:Object, channels:Vector.<ColladaChannel>, clip:ColladaElement)
        {
            _document = document;
            _upAxis = upAxis;
            _name = clip == null ? "" : clip.attribute("name") || clip.id;
            _start = clip == null ? 0 : clip.toNumber(clip.attribute("start") || "0");
            _end = _start;
            for each (var channel:ColladaChannel in channels)
            {
                if (channel.element != null)
                {
                    (_channels[channel.element.index] ||= new Vector.<ColladaChannel>()).push(channel);
                    _end = Math.max(_end, channel.sampler.end);
                }
            }
            if (clip != null && clip.attribute("end") != "")
            {
                _end = clip.toNumber(clip.attribute("end"));
                clip.refuseIf(_end < _start, "it ends before it starts");
            }
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
            finish(document);
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
                animations.push(new ColladaAnimation(document, upAxis, channelsOf(parts, read), clip));
            }
            if (clips.length == 0 && all.length > 0)
            {
                animations.push(new ColladaAnimation(document, upAxis, channelsOf(all, read), null));
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
        public function numbersAt(target:Object, time:Number):Vector.<Number>
        {
            var channels:Vector.<ColladaChannel> = _channels[target];
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
