<!DOCTYPE qgis>
<qgis><pipe><rastershader><colorrampshader colorRampType="DISCRETE">
<item value="1" color="#ff0000" label="a"/><item value="inf" color="#0000ff"/>
</colorrampshader></rastershader></pipe></qgis>
