package starlogo.models.collada
{
    import starlogo.models.FileAnimation;
    import starlogo.models.FileLimits;
    import starlogo.models.ModelData;
    import starlogo.models.turnToZUp;
    import starlogo.steps.finish;

    /**
     * A COLLADA document with animations, and what its poses share. Each ColladaAnimation has ColladaChannels, whose numbers come from
     * ColladaSamplers. A ColladaPose is the document at a time. For it a ColladaDeformation moves points by morphs and by ColladaSkins.
     *
     * @private
     */
    public final class ColladaFigure
    {
        /** The document's animations. */
        public var animations:Vector.<FileAnimation> = new Vector.<FileAnimation>();

        /** The geometries that are read, by "#" and id. The poses read them. */
        internal var meshes:Object = {};

        private var _xml:XmlReader;
        private var _limits:FileLimits;
        private var _upAxis:Object;
        private var _skins:Object = {}; // by the index of the element that places them
        private var _channels:Object = {}; // by the index of their elements

        /**
         * Reads the animations. If there are any, it makes a pose, so that the geometries and skins are read and checked.
         *
         * @param name the model's name
         * @param text the document's text
         * @param upAxis as for ColladaReader.of()
         * @throws ModelError if the document is wrong
         */
        public function ColladaFigure(name:String, text:String, upAxis:Object)
        {
            _upAxis = upAxis;
            _xml = ColladaReader.xmlOf(name, text);
            _limits = _xml.limits;
            finish(_xml);
            _limits.restart();
            readAnimations(ColladaReader.rootOf(name, _xml));
            if (animations.length > 0)
            {
                animations[0].verticesAt(0);
            }
        }

        /** The vertices at a time of an animation. They are not normalised. @param time in the document's time, seconds */
        internal function verticesAt(animation:ColladaAnimation, time:Number):Vector.<Number>
        {
            var data:ModelData = ColladaReader.dataFor(_limits.modelName, _upAxis, null);
            _limits.restart();
            finish(new ColladaReader(data, _xml, _upAxis != null, new ColladaPose(this, animation, time)));
            finish(turnToZUp(data.upAxis).transformingPoints(data.vertices));
            return data.vertices;
        }

        /** The skin of an element that places it. */
        internal function skinOf(skin:ColladaElement, instance:ColladaElement):ColladaSkin
        {
            return _skins[instance.index] ||= new ColladaSkin(skin, instance);
        }

        private function readAnimations(root:ColladaElement):void
        {
            var all:Vector.<ColladaElement> = entriesOf(root, "library_animations", "animation");
            var clips:Vector.<ColladaElement> = entriesOf(root, "library_animation_clips", "animation_clip");
            for each (var clip:ColladaElement in clips)
            {
                var parts:Vector.<ColladaElement> = new Vector.<ColladaElement>();
                for each (var part:ColladaElement in clip.childrenNamed("instance_animation"))
                {
                    parts.push(part.target("url", ["animation"]));
                }
                animations.push(ColladaAnimation.ofClip(this, clip, channelsOf(parts)));
            }
            if (clips.length == 0 && all.length > 0)
            {
                animations.push(new ColladaAnimation(this, "", channelsOf(all)));
            }
        }

        // The children with a name of all libraries with a name.
        private static function entriesOf(root:ColladaElement, libraryName:String, name:String):Vector.<ColladaElement>
        {
            var entries:Vector.<ColladaElement> = new Vector.<ColladaElement>();
            for each (var library:ColladaElement in root.childrenNamed(libraryName))
            {
                for each (var entry:ColladaElement in library.childrenNamed(name))
                {
                    entries.push(entry);
                }
            }
            return entries;
        }

        // The channels of some animations, and of those within them. A channel is read once, even if several clips have it.
        private function channelsOf(elements:Vector.<ColladaElement>):Vector.<ColladaChannel>
        {
            var channels:Vector.<ColladaChannel> = new Vector.<ColladaChannel>();
            var pending:Vector.<ColladaElement> = elements.slice().reverse();
            while (pending.length > 0)
            {
                var element:ColladaElement = pending.pop();
                _limits.countElements(1 + element.children.length, element);
                for each (var channel:ColladaElement in element.childrenNamed("channel"))
                {
                    channels.push(_channels[channel.index] ||= new ColladaChannel(channel));
                }
                for each (var inner:ColladaElement in element.childrenNamed("animation").reverse())
                {
                    pending.push(inner);
                }
            }
            return channels;
        }
    }
}
