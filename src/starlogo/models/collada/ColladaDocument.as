package starlogo.models.collada
{
    import starlogo.models.files.FileBudget;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.refuseModelIf;
    import starlogo.models.files.shortened;
    import starlogo.models.text.TextWords;
    import starlogo.steps.StepSequence;

    /**
     * A COLLADA document, and what its poses share: its geometries and its skins are read once. Its steps read the XML.
     *
     * @private
     */
    public final class ColladaDocument extends StepSequence
    {
        /** What the document may have and cost. Read only. */
        internal var budget:FileBudget;

        private var _xml:XmlReader;
        private var _meshes:Object = {}; // by the index of the geometry's element
        private var _skins:Object = {}; // by the index of the skin's element

        /** @param file the document's file */
        public function ColladaDocument(file:ModelFile)
        {
            var text:String = file.requireText();
            budget = new FileBudget(file.name, text.length);
            _xml = new XmlReader(text, budget);
            add(_xml);
        }

        /** The root, when all is read. @throws ModelError if it is not COLLADA */
        internal function get root():ColladaElement
        {
            refuseModelIf(_xml.root == null, budget.modelName, "this is not XML: expected a COLLADA document");
            _xml.root.refuseIf(_xml.root.name != "COLLADA", "expected a COLLADA document, but its root element is <" + _xml.root.name + ">");
            return _xml.root;
        }

        /** The axis that points up: "x", "y" or "z"; y if none is named. @throws ModelError if there is no such axis */
        internal function get upAxis():String
        {
            var element:ColladaElement = inAsset("up_axis");
            if (element == null)
            {
                return "y";
            }
            var axis:String = TextWords.trimmed(element.text);
            element.refuseIf(!/^[XYZ]_UP$/.test(axis), "expected X_UP, Y_UP or Z_UP, but found \"" + shortened(axis) + "\"");
            return axis.charAt(0).toLowerCase();
        }

        /** The length of the unit in metres. A unit that is no length counts as a metre. */
        internal function get metresPerUnit():Number
        {
            var element:ColladaElement = inAsset("unit");
            var metres:Number = element == null ? 1 : TextWords.toNumber(element.attribute("meter"));
            return metres > 0 && metres < Infinity ? metres : 1;
        }

        private function inAsset(name:String):ColladaElement
        {
            var asset:ColladaElement = root.child("asset");
            return asset == null ? null : asset.child(name);
        }

        /** The children with a name of all libraries with a name. */
        internal function entriesOf(libraryName:String, name:String):Vector.<ColladaElement>
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

        /** The mesh of a geometry, which may be in the scene many times. */
        internal function meshOf(geometry:ColladaElement):ColladaMesh
        {
            return _meshes[geometry.index] ||= new ColladaMesh(geometry);
        }

        /** The skin of an element, which may be in the scene many times. */
        internal function skinOf(element:ColladaElement):ColladaSkin
        {
            return _skins[element.index] ||= new ColladaSkin(element);
        }
    }
}
