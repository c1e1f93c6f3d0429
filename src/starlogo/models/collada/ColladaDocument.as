package starlogo.models.collada
{
    import starlogo.models.FileLimits;
    import starlogo.models.refuseIf;

    /**
     * A COLLADA document, and what its poses share: its geometries and its skins are read once.
     *
     * @private
     */
    public final class ColladaDocument
    {
        /** Its steps read the document. */
        internal var xml:XmlReader;

        private var _meshes:Object = {}; // by the index of the geometry's element
        private var _skins:Object = {}; // by the index of the skin's element
        private var _skeletons:Object = {}; // by the indices of the skin's element and of the element that places it

        /**
         * @param name the model's name
         * @param text the document's text
         */
        public function ColladaDocument(name:String, text:String)
        {
            refuseIf(text == null, name, "there is no text to read");
            xml = new XmlReader(text, new FileLimits(name, text.length));
        }

        /** What the document may have and cost. */
        internal function get limits():FileLimits
        {
            return xml.limits;
        }

        /** The root, when all is read. @throws ModelError if it is not COLLADA */
        internal function get root():ColladaElement
        {
            refuseIf(xml.root == null, limits.modelName, "this is not XML: expected a COLLADA document");
            xml.root.refuseIf(xml.root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + xml.root.name + ">");
            return xml.root;
        }

        /** The mesh of a geometry, which may be in the scene many times. Whether all of its points are kept counts only before it is read. */
        internal function meshOf(geometry:ColladaElement, keepsPoints:Boolean):ColladaMesh
        {
            var mesh:ColladaMesh = _meshes[geometry.index] ||= new ColladaMesh(geometry);
            mesh.keepsPoints ||= keepsPoints;
            return mesh;
        }

        /** The skin of an element, which may be in the scene many times. */
        internal function skinOf(element:ColladaElement):ColladaSkin
        {
            return _skins[element.index] ||= new ColladaSkin(element);
        }

        /** The joints of a skin at an element that places it. An element may place several skins, one after the other. */
        internal function skeletonOf(skin:ColladaSkin, instance:ColladaElement):ColladaSkeleton
        {
            return _skeletons[skin.element.index + " " + instance.index] ||= new ColladaSkeleton(skin, instance);
        }
    }
}
